// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/arm_device.h"
#include "widgets/base/badge.h"
#include "widgets/base/calm_range.h"
#include "widgets/base/number_format.h"
#include "widgets/charts/chart_elements.h"
#include "widgets/charts/polyline.h"
#include "widgets/charts/sample_history.h"

#include <QPicture>

#include <array>
#include <optional>
#include <vector>

namespace teleta::charts {

/// Columns of a history of joint samples: the torques, then the angles.
inline constexpr std::size_t kJointColumns = 2 * core::kArmJoints;

/// The picture of the joint chart: torques and, if wanted, angles of the four joints over one time axis, in
/// seconds before its right end. Thread: GUI.
class JointPlot : public QCustomPlot {
    Q_OBJECT
public:
    enum class Row { torque, angle };

    explicit JointPlot(QWidget* parent = nullptr);

    void setAnglesShown(bool shown);
    /// Size of the torques between which a touch is evaluated; marked on both sides of zero.
    void setWindow(double low_Nm, double high_Nm);
    void setTouches(std::vector<Shade> touches) { m_touches->setShades(std::move(touches)); }
    void setHeaderText(const QString& text) { m_header->setText(text); }
    [[nodiscard]] QString headerText() const { return m_header->text(); }
    void setProvenance(base::Provenance provenance);
    void retranslate();

    /// Draws the history from end - span to end (without repainting).
    void showStretch(const SampleHistory& history, double end_s, double span_s);
    void showValues(const SampleHistory& history, std::optional<std::size_t> index, bool steady);
    void setCursorLine(std::optional<double> time_s);
    void repaintOverlay();
    void forgetRanges();

    void setColours(const QPalette& palette);
    /// The picture as it is now, on white.
    [[nodiscard]] QPicture onPaper();

    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double xOf(double time_s) const;
    /// Where the curves of a row are drawn; empty when it is not shown.
    [[nodiscard]] QRect plotRect(Row row) const;
    /// Height in the picture of a torque.
    [[nodiscard]] double yOfTorque(double torque_Nm) const;
    [[nodiscard]] const ValuePanel* panelOf(Row row) const;
    [[nodiscard]] QCPGraph* graphOf(Row row, std::size_t joint) const;
    [[nodiscard]] const std::vector<Shade>& touches() const { return m_touches->shades(); }

    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;

    [[nodiscard]] static QString jointName(std::size_t joint);

private:
    struct Part {
        QCPAxisRect* rect = nullptr;
        ValuePanel* panel = nullptr;
        std::array<QCPGraph*, core::kArmJoints> graphs{};
        std::array<base::SteadyNumber, core::kArmJoints> numbers;
        base::CalmRange range{1.0};
        double scale = 1.0; ///< from SI to what is shown
        QString unit;
    };

    Part makePart(double scale, const QString& unit, double minimumSpan);
    [[nodiscard]] std::size_t parts() const { return m_anglesShown ? 2 : 1; }
    void arrange();
    void fill(std::size_t part, const SampleHistory& history, double end_s, double bucket_s);
    [[nodiscard]] double em() const;

    std::array<Part, 2> m_parts;
    bool m_anglesShown = false;
    HeaderElement* m_header;
    QCPLayoutGrid* m_grid;
    QCPLayoutElement* m_axisRoom;
    Shades* m_window;
    Shades* m_touches;
    TimeLines* m_jumps;
    TimeLines* m_cursor;
    QPalette m_colours;
    double m_span_s = 10.0;
    std::array<std::vector<PolylinePoint>, core::kArmJoints>
        m_lines; ///< kept so that drawing allocates little
};

} // namespace teleta::charts
