// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <atomic>
#include <memory>

class QProgressDialog;
class QWidget;

namespace teleta::console {

/// How far work on another thread has come, and whether it is to end. Thread: any.
struct WorkProgress {
    std::atomic<double> share{0.0};
    std::atomic<bool> cancelled{false};
};

/// How often progress is looked at.
inline constexpr int kProgressLook_ms = 50;

/// A non-modal window that shows the progress and can cancel; the caller deletes it. Thread: GUI.
[[nodiscard]] QProgressDialog* progressWindow(const QString& text, std::shared_ptr<WorkProgress> progress,
                                              QWidget* window);
/// Shows the share that is done, as long as the work is not cancelled.
void showProgress(QProgressDialog& dialog, const WorkProgress& progress);

} // namespace teleta::console
