// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/frames/frame_request.h"

#include <QString>
#include <QTimer>
#include <QWidget>

#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

class QLabel;
class QSlider;

namespace teleta::console {

/// What is wrong with a file, without the options of the command line that stand in brackets: "the name of
/// one (--array NAME)". Thread: any (pure).
[[nodiscard]] QString withoutOptions(QString problem);

/// The first frames of a file as a request reads them: a picture, a slider through them and what is in the
/// file, or why it cannot be read so. Reads on another thread; a newer request ends an older reading.
/// Thread: GUI.
class FramePreview : public QWidget {
    Q_OBJECT

public:
    static constexpr std::size_t kFrames = 500; ///< are shown, of a file with more

    /// known: a problem that is shown elsewhere, and not here again.
    explicit FramePreview(const QString& known = {}, QWidget* parent = nullptr);
    ~FramePreview() override;

    /// Reads the file in a moment, so that typing does not read it at each key.
    void setRequest(const frames::FrameRequest& request);

private:
    struct Content {
        core::ArrayLayout layout{};
        std::string unit{};
        std::vector<double> time_s{};
        std::vector<float> values{}; ///< loads, frame by frame, row-major; NaN: dead or no taxel
        float lowest = std::numeric_limits<float>::quiet_NaN();
        float highest = std::numeric_limits<float>::quiet_NaN();
        bool isAll = true;     ///< the file has no more frames
        std::string problem{}; ///< why the file cannot be opened so; there may be frames nevertheless
    };
    class Picture;

    [[nodiscard]] static Content contentOf(frames::FrameRequest request, const std::atomic<bool>& ended);
    void read();
    void showContent(Content content);
    void showFrame();

    QString m_known;
    frames::FrameRequest m_request;
    QTimer m_wait;
    std::shared_ptr<std::atomic<bool>> m_ended; ///< of the reading
    Content m_content;
    Picture* m_picture;
    QSlider* m_slider;
    QLabel* m_place;
    QLabel* m_about;
    QLabel* m_problem;
};

} // namespace teleta::console
