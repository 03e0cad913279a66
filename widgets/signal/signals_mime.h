// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/signal/signal_name.h"

#include <memory>
#include <vector>

class QMimeData;

namespace teleta::signal {

/// Signals that are dragged. Thread: GUI.
[[nodiscard]] std::unique_ptr<QMimeData> mimeOf(const std::vector<SignalId>& signalIds);
/// Empty: it holds none.
[[nodiscard]] std::vector<SignalId> signalsOf(const QMimeData& mime);

} // namespace teleta::signal
