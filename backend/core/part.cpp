// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/part.h"

#include "backend/core/failure.h"
#include "backend/core/part_file.h"

#include <QCoreApplication>

#include <string>

namespace teleta::core {

namespace {

struct PartText {
    Q_DECLARE_TR_FUNCTIONS(PartText)
};

} // namespace

Expected<const void*> loadPart(const char* name) {
    std::string reason;
    if (const void* const constant = findPart(name, reason))
        return constant;
    return failed(
        ErrorKind::unavailable,
        PartText::tr("a part of the program cannot be loaded: %1").arg(QString::fromStdString(reason)),
        PartText::tr("a complete installation of the program"));
}

} // namespace teleta::core
