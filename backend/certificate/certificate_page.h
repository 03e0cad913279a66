// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/certificate/certificate.h"

#include <QString>

namespace teleta::certificate {

/// The name of a kind of fault for people, translated. Thread: any.
[[nodiscard]] QString nameOf(FaultKind kind);

/// The certificate as a page for a browser: the verdict, a table of the kinds, a picture of all times, the
/// system, and what each kind does. Translated. Thread: any.
[[nodiscard]] QString certificatePage(const Certificate& certificate);

} // namespace teleta::certificate
