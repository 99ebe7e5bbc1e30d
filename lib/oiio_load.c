/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The second time that a module is opened, it is there already. */
#include "oiio_load.h"

#include <dlfcn.h>

const struct shim_oiio *oiio_load(struct err *err) {
    void *module = dlopen("supple-oiio.so", RTLD_NOW | RTLD_LOCAL);
    const struct shim_oiio *oiio = module ? dlsym(module, "shim_oiio") : NULL;
    if (!oiio) err_set(err, ERR_INPUT, "cannot load OpenImageIO: %s", dlerror());
    return oiio;
}
