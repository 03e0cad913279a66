// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/errors.h"
#include "app/python/core/core_bindings.h"

PYBIND11_MODULE(_core, module) {
    using namespace teleta::python;
    registerErrors();
    module.attr("version") = TELETA_VERSION;
    bindFrames(module);
    bindProcessor(module);
    bindGains(module);
    bindTouch(module);
    bindContour(module);
    bindPatterns(module);
    bindRecordings(module);
    bindStudy(module);
}
