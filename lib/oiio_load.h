/* SPDX-License-Identifier: GPL-3.0-or-later */
/* oiio_load - OpenImageIO, when it is needed.
 *
 * It comes with 260 libraries and takes 0.2 s to start, which programs that meet only PNG and PNM
 * shall not spend. So shim_oiio is a module, supple-oiio.so. Programs are linked to look for it
 * beside themselves, in ../lib/supple: below the folder of a build, or of an installation. */
#ifndef OIIO_LOAD_H
#define OIIO_LOAD_H

#include "err.h"
#include "shim_oiio.h"

/* Its functions, for as long as the program runs. NULL: it cannot be loaded, ERR_INPUT. */
const struct shim_oiio *oiio_load(struct err *err) WARN_UNUSED;

#endif
