// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/errors.h"
#include "app/python/vision/vision_bindings.h"

PYBIND11_MODULE(_vision, module) {
    using namespace teleta::python;
    registerErrors();
    bindCamera(module);
    bindTracker(module);
    bindSimulation(module);
}
