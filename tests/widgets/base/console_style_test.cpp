// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QStyleOption>
#include <QTabBar>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <functional>
#include <memory>

using namespace teleta::base;

namespace {

constexpr double kText = 4.5; ///< WCAG 2.1, 1.4.3
constexpr double kMark = 3.0; ///< WCAG 2.1, 1.4.11

/// Shown in a window, as large as it wants to be at least, with letters whose strokes have the full colour.
template <typename Control>
std::unique_ptr<Control> shown(std::unique_ptr<Control> control) {
    QFont font = control->font();
    font.setPixelSize(28);
    font.setBold(true);
    control->setFont(font);
    control->resize(control->sizeHint().expandedTo(QSize(140, 44)));
    control->show();
    return control;
}

template <typename Control, typename... Arguments>
std::unique_ptr<Control> make(Arguments... arguments) {
    return shown(std::make_unique<Control>(arguments...));
}

QImage pictureOf(QWidget& control) {
    QCoreApplication::sendPostedEvents();
    return control.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// How many pixels differ from one picture to the other with at least that contrast.
int changed(const QImage& before, const QImage& after, double least) {
    int count = 0;
    for (int y = 0; y < std::min(before.height(), after.height()); ++y)
        for (int x = 0; x < std::min(before.width(), after.width()); ++x)
            count += contrast(before.pixelColor(x, y), after.pixelColor(x, y)) >= least ? 1 : 0;
    return count;
}

/// The strongest contrast to the ground among the first pixels from a side's middle inwards.
double edgeOf(const QImage& picture, const QColor& ground) {
    const QPoint middle = picture.rect().center();
    double weakest = 21.0;
    for (const auto& [start, step] : {std::pair{QPoint(middle.x(), 0), QPoint(0, 1)},
                                      {QPoint(middle.x(), picture.height() - 1), QPoint(0, -1)},
                                      {QPoint(0, middle.y()), QPoint(1, 0)},
                                      {QPoint(picture.width() - 1, middle.y()), QPoint(-1, 0)}}) {
        double strongest = 1.0;
        for (int i = 0; i < 4; ++i)
            strongest = std::max(strongest, contrast(picture.pixelColor(start + i * step), ground));
        weakest = std::min(weakest, strongest);
    }
    return weakest;
}

} // namespace

/// Every control, drawn in both themes: text, edges, marks and the focus are seen.
class ConsoleStyleTest : public QObject {
    Q_OBJECT

private:
    static void inBothThemes() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    static void apply() {
        QFETCH(bool, dark);
        applyTheme(dark ? ThemeChoice::dark : ThemeChoice::light);
    }
    static QColor ground() { return QApplication::palette().color(QPalette::Window); }

    /// Text that is set changes enough pixels with enough contrast to what was there without it.
    template <typename Control>
    static void textReads(std::unique_ptr<Control> control, const char* name,
                          const std::function<void(Control&, const QString&)>& setText) {
        setText(*control, QStringLiteral("   "));
        const QImage without = pictureOf(*control);
        setText(*control, QStringLiteral("HHH"));
        const QImage with = pictureOf(*control);
        QVERIFY2(changed(without, with, kText) >= 60, name);
    }

private slots:
    void cleanup() { applyTheme(ThemeChoice::light); }

    void textReads_data() { inBothThemes(); }
    void textReads() {
        apply();
        const auto buttonText = [](auto& button, const QString& text) { button.setText(text); };
        textReads<QPushButton>(make<QPushButton>(), "push button", buttonText);
        auto filled = make<QPushButton>();
        filled->setDefault(true);
        textReads<QPushButton>(std::move(filled), "default button", buttonText);
        for (const bool isPressed : {false, true}) {
            auto used = make<QPushButton>();
            used->setDefault(true);
            used->setDown(isPressed);
            used->setAttribute(Qt::WA_UnderMouse);
            textReads<QPushButton>(std::move(used),
                                   isPressed ? "pressed default button" : "default button under the mouse",
                                   buttonText);
        }
        auto on = make<QPushButton>();
        on->setCheckable(true);
        on->setChecked(true);
        textReads<QPushButton>(std::move(on), "button that is on", buttonText);
        textReads<QToolButton>(make<QToolButton>(), "tool button", buttonText);
        auto quiet = make<QToolButton>();
        quiet->setAutoRaise(true);
        quiet->setCheckable(true);
        quiet->setChecked(true);
        textReads<QToolButton>(std::move(quiet), "tool button that is on", buttonText);
        auto menu = make<QToolButton>();
        menu->setPopupMode(QToolButton::InstantPopup);
        menu->setMenu(new QMenu(menu.get()));
        textReads<QToolButton>(std::move(menu), "tool button with a menu", buttonText);
        textReads<QCheckBox>(make<QCheckBox>(), "check box", buttonText);
        textReads<QRadioButton>(make<QRadioButton>(), "radio button", buttonText);
        textReads<QLineEdit>(make<QLineEdit>(), "line edit", buttonText);
        textReads<QSpinBox>(make<QSpinBox>(), "spin box",
                            [](QSpinBox& box, const QString& text) { box.setPrefix(text); });
        textReads<QGroupBox>(make<QGroupBox>(), "group box",
                             [](QGroupBox& box, const QString& text) { box.setTitle(text); });
        auto combo = make<QComboBox>();
        combo->addItem(QString());
        textReads<QComboBox>(std::move(combo), "combo box",
                             [](QComboBox& box, const QString& text) { box.setItemText(0, text); });
        auto tabs = make<QTabBar>();
        tabs->addTab(QStringLiteral("HHH"));
        tabs->addTab(QStringLiteral("HHH"));
        textReads<QTabBar>(std::move(tabs), "tab", [](QTabBar& bar, const QString& text) {
            bar.setTabText(1, text);
            bar.resize(bar.sizeHint());
        });
        auto list = make<QListWidget>();
        list->addItem(QString());
        list->setCurrentRow(0);
        textReads<QListWidget>(std::move(list), "selected row",
                               [](QListWidget& rows, const QString& text) { rows.item(0)->setText(text); });
        auto table = make<QTableWidget>(1, 1);
        table->resize(300, 120);
        textReads<QTableWidget>(std::move(table), "header", [](QTableWidget& rows, const QString& text) {
            rows.setHorizontalHeaderItem(0, new QTableWidgetItem(text));
        });
    }

    void aChoiceThatIsTooLongEndsWithDots() {
        QComboBox combo;
        combo.resize(100, 30);
        const auto pictureWith = [&combo](const QString& text) {
            combo.clear();
            combo.addItem(text);
            return combo.grab().toImage();
        };
        const QString text = QStringLiteral("long and longer");
        QStyleOptionComboBox option;
        option.initFrom(&combo);
        const QRect field =
            combo.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo);
        const QString dotted = combo.fontMetrics().elidedText(text, Qt::ElideRight, field.width() - 2);
        QVERIFY(dotted != text);
        QCOMPARE(pictureWith(text), pictureWith(dotted));
    }

    void edgesAreSeen_data() { inBothThemes(); }
    void edgesAreSeen() {
        apply();
        auto filled = make<QPushButton>();
        filled->setDefault(true);
        const auto combo = make<QComboBox>();
        const auto spin = make<QSpinBox>();
        const auto line = make<QLineEdit>();
        const auto button = make<QPushButton>();
        const auto tool = make<QToolButton>();
        for (QWidget* control : std::initializer_list<QWidget*>{filled.get(), combo.get(), spin.get(),
                                                                line.get(), button.get(), tool.get()}) {
            control->clearFocus();
            const double edge = edgeOf(pictureOf(*control), ground());
            QVERIFY2(edge >= kMark, qPrintable(QStringLiteral("%1: %2")
                                                   .arg(QLatin1String(control->metaObject()->className()))
                                                   .arg(edge)));
        }
    }

    void marksAreSeen_data() { inBothThemes(); }
    void marksAreSeen() {
        apply();
        const auto on = [](QAbstractButton& button) {
            button.setCheckable(true);
            const QImage before = pictureOf(button);
            button.setChecked(true);
            return changed(before, pictureOf(button), kMark);
        };
        QVERIFY(on(*make<QCheckBox>()) >= 40);
        QVERIFY(on(*make<QRadioButton>()) >= 40);

        const auto tabs = make<QTabBar>();
        tabs->addTab(QStringLiteral("HHH"));
        tabs->addTab(QStringLiteral("HHH"));
        tabs->resize(tabs->sizeHint());
        QImage before = pictureOf(*tabs);
        tabs->setCurrentIndex(1);
        QVERIFY2(changed(before, pictureOf(*tabs), kMark) >= tabs->tabRect(1).width(), "the chosen tab");

        const auto slider = make<QSlider>(Qt::Horizontal);
        slider->setRange(0, 100);
        before = pictureOf(*slider);
        slider->setValue(100);
        QVERIFY2(changed(before, pictureOf(*slider), kMark) >= slider->width(), "the way of a slider");

        const auto bar = make<QProgressBar>();
        bar->setTextVisible(false);
        bar->setRange(0, 100);
        bar->setValue(0);
        before = pictureOf(*bar);
        bar->setValue(50);
        QVERIFY2(changed(before, pictureOf(*bar), kMark) >= bar->width() / 4 * 8, "progress");

        const auto scroll = make<QScrollBar>(Qt::Vertical);
        scroll->resize(20, 300);
        scroll->setRange(0, 300);
        scroll->setPageStep(100);
        before = pictureOf(*scroll);
        scroll->setValue(300);
        QVERIFY2(changed(before, pictureOf(*scroll), kMark) >= 100, "the handle of a scroll bar");
    }

    void theFocusIsSeen_data() { inBothThemes(); }
    void theFocusIsSeen() {
        apply();
        QWidget window;
        window.resize(600, 600);
        auto* first = new QLineEdit(&window);
        auto add = [&, y = 50](QWidget* control) mutable {
            control->setParent(&window);
            control->setGeometry(20, y, 200, 32);
            y += 40;
            return control;
        };
        auto* filled = new QPushButton(QStringLiteral("x"));
        filled->setDefault(true);
        auto* tool = new QToolButton;
        tool->setFocusPolicy(Qt::StrongFocus);
        auto* check = new QCheckBox(QStringLiteral("x"));
        auto* slider = new QSlider(Qt::Horizontal);
        auto* tabs = new QTabBar;
        tabs->addTab(QStringLiteral("x"));
        const std::vector<QWidget*> controls{add(new QLineEdit), add(new QComboBox), add(new QPushButton),
                                             add(filled),        add(tool),          add(check),
                                             add(slider),        add(new QSpinBox),  add(tabs)};
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.activateWindow();
        first->setFocus();
        QTRY_VERIFY(first->hasFocus());
        std::vector<QImage> before;
        for (QWidget* control : controls)
            before.push_back(pictureOf(*control));
        for (std::size_t i = 0; i < controls.size(); ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QVERIFY2(controls[i]->hasFocus(), controls[i]->metaObject()->className());
            QVERIFY2(changed(before[i], pictureOf(*controls[i]), kMark) >= 24,
                     controls[i]->metaObject()->className());
        }
    }

    /// A scroll bar without buttons: its handle goes from end to end, and a click beside it turns a page.
    void theNameOfAGroupInAMenuHasTheRoomOfAnEntry() {
        QMenu menu;
        const QAction* name = menu.addSection(QStringLiteral("A group with a long name"));
        const QAction* entry = menu.addAction(QStringLiteral("entry"));
        menu.popup(QPoint(0, 0));
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        const QRect room = menu.actionGeometry(const_cast<QAction*>(name));
        QVERIFY(room.height() >= menu.actionGeometry(const_cast<QAction*>(entry)).height());
        QFont bold = menu.font();
        bold.setBold(true);
        QVERIFY(room.width() >= QFontMetrics(bold).horizontalAdvance(name->text()));
    }

    void aRowThatIsChosenShowsNoCellApart() {
        QTableWidget table(3, 3);
        table.setSelectionMode(QAbstractItemView::SingleSelection);
        table.setSelectionBehavior(QAbstractItemView::SelectRows);
        table.setEditTriggers(QAbstractItemView::NoEditTriggers);
        table.setShowGrid(false);
        table.resize(400, 200);
        table.show();
        table.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&table));
        table.setFocus();
        const auto picture = [&](int column, const QAbstractItemView::SelectionBehavior behaviour) {
            table.setSelectionBehavior(behaviour);
            table.setCurrentCell(1, column);
            QTest::keyClick(&table, Qt::Key_Right); // the ring is for the keyboard
            return pictureOf(*table.viewport());
        };
        // The ring of a cell moves with the current column; a row stays as it is.
        QVERIFY(picture(0, QAbstractItemView::SelectRows) == picture(1, QAbstractItemView::SelectRows));
        QVERIFY(picture(0, QAbstractItemView::SelectItems) != picture(1, QAbstractItemView::SelectItems));
    }

    void aScrollBarIsUsedWithTheMouse() {
        const auto bar = make<QScrollBar>(Qt::Vertical);
        bar->resize(20, 300);
        bar->setRange(0, 200);
        bar->setPageStep(100);
        QTest::mouseClick(bar.get(), Qt::LeftButton, {}, QPoint(10, 290));
        QCOMPARE(bar->value(), 100);
        QTest::mouseClick(bar.get(), Qt::LeftButton, {}, QPoint(10, 5));
        QCOMPARE(bar->value(), 0);
        QTest::mousePress(bar.get(), Qt::LeftButton, {}, QPoint(10, 50));
        QTest::mouseMove(bar.get(), QPoint(10, 250));
        QTest::mouseRelease(bar.get(), Qt::LeftButton, {}, QPoint(10, 250));
        QCOMPARE(bar->value(), 200);
    }

    void controlsOfARowHaveTheSameHeight() {
        const QPushButton button(QStringLiteral("x"));
        const QComboBox combo;
        const QSpinBox spin;
        const QLineEdit line;
        QCOMPARE(combo.sizeHint().height(), button.sizeHint().height());
        QCOMPARE(spin.sizeHint().height(), button.sizeHint().height());
        QCOMPARE(line.sizeHint().height(), button.sizeHint().height());
    }
};

static const teleta::test::Registration<ConsoleStyleTest> registration;

#include "console_style_test.moc"
