// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/version.h"
#include "app/python/base/errors.h"
#include "app/python/core/core_bindings.h"

#include <QCoreApplication>

PYBIND11_MODULE(_core, module) {
    using namespace teleta::python;
    registerErrors();
    module.attr("version") = TELETA_VERSION;
    // Recordings and exports carry it. A program that has its own keeps that.
    if (QCoreApplication::applicationVersion().isEmpty())
        QCoreApplication::setApplicationVersion(teleta::app::version().text());
    bindFrames(module);
    bindProcessor(module);
    bindGains(module);
    bindTouch(module);
    bindContour(module);
    bindPatterns(module);
    bindRecordings(module);
    bindStudy(module);
}
