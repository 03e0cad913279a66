// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/watermark.h"

#include <QCoreApplication>

namespace teleta::study {

QString watermarkOf(std::optional<Mode> mode) {
    if (!mode || *mode == Mode::run)
        return {};
    return *mode == Mode::pilot ? QCoreApplication::translate("StudyFigure", "PILOT")
                                : QCoreApplication::translate("StudyFigure", "SIMULATED");
}

} // namespace teleta::study
