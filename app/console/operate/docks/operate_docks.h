// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QMainWindow>
#include <QRect>
#include <QSize>
#include <QString>
#include <QStringList>

#include <array>
#include <cstddef>
#include <initializer_list>

class QAction;
class QDockWidget;

namespace teleta::console {

/// The docks of the Operate page. An array on its own, an arm with or without a skin, a servo, a camera in a
/// tube and a flat gel show different views, so each kind of source has a layout of its own, which is kept
/// while another is shown. The scene has its place in all of them and is there while a camera looks at it.
/// Thread: GUI.
class OperateDocks : public QMainWindow {
    Q_OBJECT

public:
    /// joints: an arm without a tactile skin; scene: a camera that is only looked at.
    enum class Kind { array, arm, servo, camera, joints, gel, scene };
    static constexpr std::size_t kKinds = 7;

    enum Dock {
        heatmap,
        reconstruction,
        charts,
        processing,
        stiffness,
        bracelet,
        joints,
        touches,
        jog,
        feedback,
        contour,
        servo,
        runs,
        objects,
        camera,
        events,
        gel,
        gelEvents,
        scene,
        marks
    };
    static constexpr std::size_t kDocks = 20;
    /// Whether a kind of source shows a dock; the scene is shown while there is one, see setHasScene().
    [[nodiscard]] static bool belongs(Kind kind, std::size_t dock);

    /// Where a floating window goes when a screen is gone: where it is as long as its title bar can be
    /// reached on a screen, else into the middle of `home`, no larger than that. grip: what is enough of a
    /// title bar.
    [[nodiscard]] static QRect reachablePlace(const QRect& window, const QList<QRect>& screens,
                                              const QRect& home, QSize grip);

    explicit OperateDocks(QWidget* parent = nullptr);

    /// Puts a view into its dock, which owns it; once for each dock, before anything is shown.
    void add(Dock dock, QWidget* view);
    /// Like add(), for a form, which cannot shrink: it scrolls when its dock is too low.
    void addScrolling(Dock dock, QWidget* view);
    /// Call once all views are added: builds the default layouts.
    void begin();

    void setKind(Kind kind);
    /// In a small window the pictures of an arm, a servo or an array lie upon each other as tabs, beside the
    /// forms. That is a layout of its own.
    void setSmall(bool small);
    [[nodiscard]] Kind kind() const { return m_kind; }
    /// Shows the scene as soon as there is one, and hides it when there is none. A person can close it
    /// meanwhile.
    void setHasScene(bool has);
    /// Names of the docks, for options and settings.
    [[nodiscard]] static QStringList names();
    /// Brings a dock to the front as soon as a source shows it; unknown names are ignored.
    void bringForward(const QString& name);

    /// Shows and hides docks; those that do not belong to this kind of source are disabled.
    [[nodiscard]] QList<QAction*> actions() const;

    /// Shows one dock alone, with all the room; an empty name brings the others back as they were. A floating
    /// dock, and one that this kind of source does not show, stays as it is.
    void setMaximised(const QString& name);
    /// Name of the dock that is shown alone; empty: none.
    [[nodiscard]] QString maximised() const { return m_alone; }
    /// Maximises the dock with the focus, or else the one in which something was done last; or brings the
    /// others back.
    void toggleMaximised();

    /// All layouts, without a dock that is maximised.
    [[nodiscard]] QByteArray saveLayouts() const;
    /// False if they are damaged or of another version; the default layouts are used then.
    bool restoreLayouts(const QByteArray& layouts);
    /// Restores the default layout of the kind that is shown.
    void resetLayout();
    void retranslate();

signals:
    void maximisedChanged(bool any);

protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// What a layout is kept for: a kind of source in a window that is large, or small where that differs.
    static constexpr std::size_t kLayouts = 2 * kKinds;
    [[nodiscard]] std::size_t index() const {
        return static_cast<std::size_t>(m_kind) + (isStacked() ? kKinds : 0);
    }
    [[nodiscard]] bool isStacked() const;
    void change(Kind kind, bool small);
    [[nodiscard]] bool restore(const QByteArray& layout);
    void arrange();
    /// Gives each dock of the kind its place and shows it, but for the scene.
    void arrangeKind();
    void arrangeStacked();
    void showScene();
    /// Of this kind of source, and not a scene that nothing looks at.
    [[nodiscard]] bool isUsed(std::size_t dock) const;
    void shareSpace();
    void shareAmongKind();
    void shareStacked();
    /// Pixels for the first of some docks that stands in the layout, or for what stands behind or before it.
    struct Share {
        std::initializer_list<Dock> docks;
        int size;
    };
    /// What is closed leaves its share to the others, but forms keep their width.
    void share(std::initializer_list<Share> shares, Qt::Orientation orientation);
    [[nodiscard]] QDockWidget* standing(std::initializer_list<Dock> docks) const;
    [[nodiscard]] static bool isForm(std::size_t dock);
    [[nodiscard]] int neededHeight(Dock dock) const;
    /// Remembers the sizes of the docks that are seen.
    void noteSizes();
    [[nodiscard]] bool isSeen(std::size_t dock) const;
    [[nodiscard]] int tabRoom(const QDockWidget& dock) const;
    /// Of the docks that are seen; invalid of the others.
    [[nodiscard]] std::array<QSize, kDocks> sizesNow() const;
    /// Those that a restored layout tells, or notes what there are.
    void bringSizes();
    /// Those that were noted, in a window of another size: forms keep their width, pictures grow and shrink.
    void keepSizes();
    void enableActions();
    void bringBack();
    void showFocus(const QWidget* before, const QWidget* now);
    void showAlone(const QString& name);
    void forgetMaximised();
    [[nodiscard]] QByteArray stateNow() const;

    std::array<QDockWidget*, kDocks> m_docks{};
    Kind m_kind = Kind::array;
    bool m_small = false;  ///< the window
    QString m_alone;       ///< name of the dock that is shown alone
    QByteArray m_together; ///< the layout that it came out of; empty: none is shown alone
    QString m_lastUsed;    ///< name of the dock that had the focus last
    QString m_forward;     ///< name of the dock that comes to the front with the next layout
    std::array<QByteArray, kLayouts> m_layouts; ///< of those that are not shown; empty: never shown
    std::array<bool, kLayouts> m_default{};     ///< shares its space anew when it is shown or resized
    bool m_hasScene = false;
    std::array<bool, kLayouts> m_sceneClosed{}; ///< by a person
    bool m_building = false;                    ///< a layout is built or restored
    std::array<QSize, kDocks> m_sizes{};        ///< as they were chosen; of a dock that was not seen: invalid
    QSize m_sizesIn;                            ///< of this widget then
};

} // namespace teleta::console
