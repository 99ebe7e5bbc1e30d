/* SPDX-License-Identifier: GPL-3.0-or-later */
/* utf8 - which bytes are characters: comments may hold anything, JSON and XML may not. */
#ifndef UTF8_H
#define UTF8_H

/* Length, 1..4, of the character of well-formed UTF-8 that begins at s < end; 0: there is none.
 * Overlong forms, surrogates, what exceeds U+10FFFF and the noncharacters U+FFFE, U+FFFF are none;
 * control characters are characters. */
int utf8_length(const char *s, const char *end);

#endif
