# SPDX-License-Identifier: GPL-3.0-or-later
# What decles-edit --verbose reports of an edit of phi, in words, a line each, for the text of a figure;
# -v tail=WORD is added to each word. The report itself goes first.
BEGIN {
    word["|A|"] = "anchors"; word["|S|"] = "slaves"; word["|D|"] = "derived"; word["|E|"] = "conditions"
    word["rank"] = "rank"; word["redundant"] = "redundant"; word["added"] = "added"
    word["displacement"] = "displacement"; word["gain"] = "gain"
}
{ print }
/ phi / { for (i = 1; i < NF; i++) if ($i in word) said[++n] = word[$i] tail " " $(i + 1) }
END { for (i = 1; i <= n; i++) print said[i] }
