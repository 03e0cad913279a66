// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/plot_version.h"

#include <qcustomplot.h>

namespace teleta::charts {

QString plotLibraryVersion() {
    return QStringLiteral(QCUSTOMPLOT_VERSION_STR);
}

} // namespace teleta::charts
