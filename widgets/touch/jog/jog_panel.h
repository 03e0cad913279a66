// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/arm_report.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/touch/jog/position_guide.h"

#include <QTimer>
#include <QWidget>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace teleta::arm_model {
class SerialChain;
}

namespace teleta::base {
class HoldButton;
}

namespace teleta::touch {

/// The motion that a hand on a 3D mouse asks for.
struct HandMotion {
    std::array<double, 3>
        velocity{}; ///< -1 .. 1 of the full deflection, right, away, up: x, y, z of the base
    bool deadManHeld = false;
    bool clutchHeld = false;
};

class DriveSign;
class JointRange;
class JointTold;
class LimitLine;

/// Moves the arm by hand, joint by joint or its tip along the axes of the base. The arm moves only while the
/// dead-man switch (Shift, or the button on the screen) is held. Letting go of it, losing the keyboard focus
/// or the window, hiding, STOP, or losing the arm sends zero at once and releases everything, so that
/// nothing goes on by itself.
///
/// By velocity, the arm moves as long as a direction (a button, or its key) is held, too. By position, the
/// tip goes where it is led: each press of a direction is a step of the scale, and the deflection of a 3D
/// mouse is a displacement, kFullStep_m at full deflection and 100 %. While the clutch (C, its button, or the
/// second one of a 3D mouse) is held, the arm stands still; afterwards a new hold begins where the tip is, as
/// when the keys take over from the mouse or the mouse from the keys. Joints are always moved by velocity.
///
/// A 3D mouse moves the tip, whatever the mode, while its own dead-man button is held; it needs no focus.
/// After STOP, another arm or old joint readings it has no effect until its button has been released.
///
/// Keys while the panel has the focus: Q W E R T Y U turn the joints 1 to 7 up, A S D F G H J down; with the
/// tip, D A move along x, W S along y, E Q along z. Thread: GUI.
class JogPanel : public QWidget {
    Q_OBJECT
public:
    enum class Mode { joints, tip };
    enum class Way { velocity, position };
    static constexpr double kFullStep_m = 0.05;
    static constexpr int kPeriod_ms = 33; ///< of jogRequested() while it moves

    explicit JogPanel(QWidget* parent = nullptr);
    ~JogPanel() override;

    /// The connected arm; empty: none. chain: its joints and links where a file describes them.
    void setArm(const std::optional<core::ArmDescription>& arm,
                std::shared_ptr<const arm_model::SerialChain> chain = nullptr);
    /// The newest reading of the joints.
    void setSample(const core::JointSample& sample);
    void setDrive(core::ArmDrive drive);
    /// What the arm tells now besides its samples, again and again; of an arm that tells nothing, an empty
    /// report.
    void setReport(const core::ArmReport& report);
    void setStopEngaged(bool engaged);
    /// Age of the newest reading: the older, the more slowly the tip is guided by position.
    void setReadingsAge(double age_s) { m_age_s = age_s; }
    /// The joint readings are stale: the arm is not moved blindly.
    void setReadingsOld(bool old);
    /// What acts on the tip; empty: it is not known.
    void setWrench(const std::optional<core::WrenchSample>& wrench);
    /// Why the arm does not move although it may be asked to, without a full stop; empty: nothing is in the
    /// way.
    void setHindrance(const QString& reason);
    /// Reading of a 3D mouse; empty: none is connected.
    void setHand(const std::optional<HandMotion>& hand);
    /// Its state, in a line; empty: not shown.
    void setHandText(const QString& text);

    /// Stops moving the arm; keys, buttons and the mouse's dead man count again once they were
    /// released.
    void letGo();

    /// low: lower buttons and fewer words, for a low window. narrow: narrower buttons, too, and Run,
    /// Hold and Restart without their names.
    void setCompact(bool low, bool narrow);
    void setMode(Mode mode);
    [[nodiscard]] Mode mode() const { return m_mode; }
    void setWay(Way way);
    /// Share of the full speed, in percent 1..100.
    void setSpeed(int percent);

    /// The rates requested now.
    [[nodiscard]] const core::JointVector& rate_radPerS() const { return m_rate; }
    [[nodiscard]] bool isMoving() const;
    /// Why jogging is impossible; empty when it is possible.
    [[nodiscard]] QString refusal() const;

public slots:
    /// Releases everything; sends zero if the arm was moving.
    void releaseAll();

signals:
    /// At 30 Hz while the arm shall move and at every change; one zero when it shall stand still.
    void jogRequested(const core::JointVector& rate_radPerS);
    void programRunRequested(bool running);
    void programRestartRequested();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// A joint, and the buttons of the joint or of an axis of the tip.
    struct Row {
        QLabel* name;
        JointRange* range;
        JointTold* told;
        QLabel* place;                            ///< of the tip along this axis, instead of the range
        std::array<base::HoldButton*, 2> buttons; ///< 0 down, 1 up
    };
    void showHint();
    void showTip();
    void showWrench();
    [[nodiscard]] bool hasKeyboard() const;
    /// Who guides the tip by position.
    enum class Leader { nobody, keys, hand };

    [[nodiscard]] bool isOwnKey(int key) const;
    void onKey(const QKeyEvent& event, bool pressed);
    [[nodiscard]] std::array<double, 3> handVelocity() const {
        return m_handReady && m_hand.deadManHeld ? m_hand.velocity : std::array<double, 3>{};
    }
    [[nodiscard]] bool canMoveTip() const;
    [[nodiscard]] Eigen::Vector3d tipPosition(const core::JointVector& angle_rad) const;
    [[nodiscard]] core::JointVector tipRates(const core::JointVector& angle_rad,
                                             const Eigen::Vector3d& velocity_mPerS);
    [[nodiscard]] core::JointVector tipRate(const std::array<double, 3>& share);
    [[nodiscard]] core::JointVector guidedRate();
    void leadBy(Leader leader);
    void stepBy(std::size_t axis, bool up);
    [[nodiscard]] bool isGuided() const { return m_way == Way::position && m_mode == Mode::tip; }
    void onDirectionHeld(bool held, Qt::KeyboardModifiers modifiers);
    void take();
    [[nodiscard]] core::JointVector wanted();
    /// Of the arm; without one, of the usual arm.
    [[nodiscard]] std::size_t joints() const;
    [[nodiscard]] std::size_t axes() const;
    [[nodiscard]] core::JointVector noRate() const { return core::JointVector::zeros(joints()); }
    /// up: towards larger values.
    [[nodiscard]] base::HoldButton* directionButton(std::size_t axis, bool up) const;
    /// As many as the arm needs.
    void addRows();
    [[nodiscard]] QString jointName(std::size_t joint) const;
    void enableParts();
    void fitButtons();
    void showHandText();
    void showSpeed();
    void retranslate();

    std::optional<core::ArmDescription> m_arm;
    std::shared_ptr<const arm_model::SerialChain> m_chain; ///< of m_arm; null: not described
    QString m_hindrance;
    core::JointSample m_sample;
    bool m_hasSample = false;
    bool m_stopEngaged = false;
    bool m_readingsOld = false;
    bool m_isLow = false;
    bool m_isNarrow = false;
    double m_age_s = 0.0; ///< of m_sample
    base::SteadyNumber m_force_N;
    base::SteadyNumber m_torque_Nm;
    HandMotion m_hand;
    bool m_hasHand = false;
    bool m_handReady = false; ///< its button was let go since it was taken out of effect
    Mode m_mode = Mode::joints;
    Way m_way = Way::velocity;
    PositionGuide m_guide;
    Leader m_leader = Leader::nobody; ///< who has hold of m_guide
    bool m_clutchKey = false;
    core::JointVector m_rate;
    bool m_singular = false; ///< damping near a singularity slowed m_rate down
    bool m_shift = false;
    std::array<std::array<bool, 2>, core::JointVector::kCapacity> m_keys{}; ///< held: [axis][0 down, 1 up]
    QTimer m_timer;

    QLabel* m_message;
    LimitLine* m_limits;
    QLabel* m_wrench;
    QLabel* m_handText;
    DriveSign* m_driveSign;
    QPushButton* m_run;
    QPushButton* m_hold;
    QPushButton* m_restart;
    QComboBox* m_modeBox;
    QComboBox* m_wayBox;
    QSlider* m_speed;
    QLabel* m_speedLabel;
    QLabel* m_speedText;
    base::HoldButton* m_deadMan;
    base::HoldButton* m_clutch;
    QGridLayout* m_grid;
    std::vector<Row> m_rows;
};

} // namespace teleta::touch
