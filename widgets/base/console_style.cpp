// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/console_style.h"

#include "widgets/base/control_painter.h"
#include "widgets/base/icons.h"
#include "widgets/base/theme.h"

#include <QAbstractItemView>
#include <QMainWindow>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>

#include <algorithm>
#include <cmath>

namespace teleta::base {

namespace {

constexpr double kControlHeight = 3.25; ///< of fields and buttons, in grids
constexpr int kFieldEdge_px = 2;
constexpr int kComboText_px = 1;         ///< from the edit field of a combo box to its text in Fusion
constexpr int kComboIcon_px = 4;         ///< from its icon to its text, likewise
constexpr double kScrollExtent = 1.5;    ///< width of a scroll bar, likewise
constexpr double kScrollHandle = 0.75;   ///< of its handle
constexpr double kLeastHandle = 3.0;     ///< its length at least
constexpr double kGroove = 0.5;          ///< thickness of a slider's groove
constexpr double kMenuArrow = 2.0;       ///< room for the arrow of a tool button with a menu
constexpr double kSeparatorLength = 3.0; ///< of the grip between two views
constexpr double kComboArrow = 1.0;    ///< more room in front of the arrow of a combo box than Fusion leaves
constexpr double kButtonMargin = 0.75; ///< more room left and right of a button's text, both together
constexpr double kCellMargin = 0.375;  ///< left and right of the text of a cell
constexpr double kSectionHeight = 3.5; ///< of the name of a group in a menu

double gridOf(const QStyleOption* option) {
    return option != nullptr ? std::max(4.0, 0.5 * option->fontMetrics.height()) : 8.0;
}

bool hasMenuArrow(const QStyleOptionComplex* option) {
    const auto* tool = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    return tool != nullptr && tool->features.testFlag(QStyleOptionToolButton::HasMenu) &&
           !tool->features.testFlag(QStyleOptionToolButton::MenuButtonPopup);
}

/// The name of a group in a menu.
const QStyleOptionMenuItem* menuSection(const QStyleOption* option) {
    const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
    return item != nullptr && item->menuItemType == QStyleOptionMenuItem::Separator && !item->text.isEmpty()
               ? item
               : nullptr;
}

/// A view whose selection tells where the keyboard is: whole rows, one of them, and nothing to type in a
/// cell.
bool showsRowAsCurrent(const QAbstractItemView& view) {
    return view.selectionBehavior() == QAbstractItemView::SelectRows &&
           view.selectionMode() == QAbstractItemView::SingleSelection &&
           view.editTriggers() == QAbstractItemView::NoEditTriggers;
}

bool isFilled(const QStyleOption* option) {
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
    return button != nullptr && button->features.testFlag(QStyleOptionButton::DefaultButton) &&
           !button->features.testFlag(QStyleOptionButton::Flat);
}

void drawCheck(const QStyleOption& option, QPainter& painter) {
    ControlPainter flat(painter, option);
    // The edge of a selected row's box is that of its text.
    const bool isOn = flat.has(QStyle::State_On) || flat.has(QStyle::State_NoChange);
    const QRectF box(option.rect);
    flat.box(box, isOn ? flat.colours().accent : option.palette.color(QPalette::Base),
             flat.focused() ? flat.colours().ring : flat.colours().edge, 0.375,
             flat.focused() ? ControlPainter::kRing_px : 1.0);
    if (flat.has(QStyle::State_On)) {
        flat.tick(box, flat.colours().onAccent);
    } else if (flat.has(QStyle::State_NoChange)) {
        const double thin = 0.45 * box.height();
        flat.box(box.adjusted(0.25 * box.width(), thin, -0.25 * box.width(), -thin), flat.colours().onAccent,
                 {}, 0.0);
    }
}

void drawRadio(const QStyleOption& option, QPainter& painter) {
    ControlPainter flat(painter, option);
    const bool isOn = flat.has(QStyle::State_On);
    const QRectF box(option.rect);
    const double round = box.width() / flat.px(1.0); // more than half of it
    flat.box(box, isOn ? flat.colours().accent : option.palette.color(QPalette::Base),
             flat.focused() ? flat.colours().ring : flat.colours().edge, round,
             flat.focused() ? ControlPainter::kRing_px : 1.0);
    const double in = 0.31 * box.width();
    if (isOn)
        flat.box(box.adjusted(in, in, -in, -in), flat.colours().onAccent, {}, round);
}

void drawSlider(const QStyleOptionSlider& option, QPainter& painter, const QRectF& groove,
                const QRectF& handle) {
    ControlPainter flat(painter, option);
    const bool lies = option.orientation == Qt::Horizontal;
    const double half = 0.5 * flat.px(kGroove);
    const QPointF middle = handle.center();
    QRectF way = lies ? QRectF(groove.left(), middle.y() - half, groove.width(), 2.0 * half)
                      : QRectF(middle.x() - half, groove.top(), 2.0 * half, groove.height());
    flat.box(way, flat.colours().groove, {});
    if (lies != option.upsideDown && lies)
        way.setRight(middle.x());
    else if (lies)
        way.setLeft(middle.x());
    else if (option.upsideDown)
        way.setTop(middle.y());
    else
        way.setBottom(middle.y());
    const QColor mark = flat.enabled() ? flat.colours().ring : flat.colours().handle;
    flat.box(way, mark, {});
    const double side = std::min({handle.width(), handle.height(), flat.px(kGroup)});
    const QRectF knob(middle.x() - 0.5 * side, middle.y() - 0.5 * side, side, side);
    flat.box(knob, flat.filled(mark), option.palette.color(QPalette::Base), side, ControlPainter::kRing_px);
    if (flat.focused())
        flat.box(knob, {}, option.palette.color(QPalette::Active, QPalette::WindowText), side,
                 ControlPainter::kRing_px);
}

void drawTab(const QStyleOptionTab& option, QPainter& painter) {
    ControlPainter flat(painter, option);
    const bool isChosen = flat.has(QStyle::State_Selected);
    const QRectF rect(option.rect);
    if (!isChosen && flat.under())
        flat.box(rect, flat.colours().hover, {});
    QRectF mark = rect; // tabs are above what they choose
    mark.setTop(rect.bottom() - flat.px(kStripe));
    if (isChosen)
        painter.fillRect(mark, flat.enabled() ? flat.colours().ring : flat.colours().edge);
    if (flat.focused() && isChosen)
        flat.box(rect.adjusted(1, 1, -1, -1), {}, flat.colours().ring, kControlRadius,
                 ControlPainter::kRing_px);
}

/// Of message boxes that ask.
IconDrawing questionMark() {
    IconDrawing drawing;
    drawing.strokes.addEllipse(QPointF(12.0, 12.0), 9.0, 9.0);
    drawing.strokes.moveTo(9.2, 9.7);
    drawing.strokes.cubicTo(9.2, 6.1, 14.8, 6.1, 14.8, 9.7);
    drawing.strokes.cubicTo(14.8, 11.9, 12.0, 11.7, 12.0, 14.0);
    drawing.fills.addEllipse(QPointF(12.0, 17.0), 1.3, 1.3);
    return drawing;
}

} // namespace

ConsoleStyle::ConsoleStyle()
    : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {
}

void ConsoleStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
    switch (element) {
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
        return drawCheck(*option, *painter);
    case PE_IndicatorRadioButton:
        return drawRadio(*option, *painter);
    case PE_PanelButtonCommand: {
        const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        ControlPainter flat(*painter, *option);
        const bool isQuiet = button != nullptr && button->features.testFlag(QStyleOptionButton::Flat);
        const bool isOn = flat.has(State_On);
        if (!isQuiet)
            return flat.button(isFilled(option), isOn);
        if (flat.pressed() || isOn || flat.under())
            flat.box(option->rect,
                     flat.under() && !flat.pressed() ? flat.colours().hover : flat.colours().pressed, {});
        if (flat.focused())
            flat.ring(option->rect);
        return;
    }
    case PE_PanelButtonTool:
    case PE_PanelButtonBevel: {
        ControlPainter flat(*painter, *option);
        const bool isOn = flat.has(State_On);
        const bool isOutlined = !flat.has(State_AutoRaise) && element == PE_PanelButtonTool;
        const QColor ground = flat.pressed() || isOn ? flat.colours().pressed
                              : flat.under()         ? flat.colours().hover
                              : isOutlined
                                  ? option->palette.color(flat.enabled() ? QPalette::Base : QPalette::Window)
                                  : QColor();
        if (ground.isValid() || isOutlined)
            flat.box(option->rect, ground, isOutlined ? flat.colours().edge : QColor());
        if (flat.focused())
            flat.box(option->rect, {}, flat.colours().ring, kControlRadius, ControlPainter::kRing_px);
        return;
    }
    case PE_FrameFocusRect: {
        ControlPainter flat(*painter, *option);
        // Buttons and tabs show it themselves.
        if (!flat.has(State_KeyboardFocusChange) || qobject_cast<const QTabBar*>(widget) != nullptr)
            return;
        const auto* view = qobject_cast<const QAbstractItemView*>(widget);
        const bool isCell = view != nullptr;
        if (isCell && flat.has(State_Selected) && showsRowAsCurrent(*view))
            return;
        const QColor ring = isCell && flat.has(State_Selected)
                                ? option->palette.color(QPalette::HighlightedText)
                                : flat.colours().ring;
        return flat.box(option->rect, {}, ring, isCell ? 0.25 : kControlRadius, 1.5);
    }
    case PE_PanelLineEdit:
        if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
            frame != nullptr && frame->lineWidth > 0)
            return ControlPainter(*painter, *option).field(option->rect);
        break;
    case PE_FrameLineEdit:
        return;
    case PE_Frame:
    case PE_FrameGroupBox: {
        ControlPainter flat(*painter, *option);
        const bool isUsed = element == PE_Frame && flat.focused();
        return flat.box(option->rect, {}, isUsed ? flat.colours().ring : flat.colours().faint,
                        element == PE_Frame ? 0.25 : kCardRadius);
    }
    case PE_FrameTabWidget:
    case PE_FrameDockWidget:
        return;
    case PE_FrameTabBarBase:
        painter->fillRect(QRectF(option->rect.left(), option->rect.bottom(), option->rect.width(), 1.0),
                          controlColours(option->palette, true).faint);
        return;
    case PE_IndicatorArrowUp:
    case PE_IndicatorArrowDown:
    case PE_IndicatorArrowLeft:
    case PE_IndicatorArrowRight: {
        ControlPainter flat(*painter, *option);
        return flat.chevron(option->rect,
                            element == PE_IndicatorArrowUp     ? Qt::UpArrow
                            : element == PE_IndicatorArrowDown ? Qt::DownArrow
                            : element == PE_IndicatorArrowLeft ? Qt::LeftArrow
                                                               : Qt::RightArrow,
                            flat.ink());
    }
    case PE_IndicatorDockWidgetResizeHandle: {
        ControlPainter flat(*painter, *option);
        QRectF grip(0, 0, flat.px(kHair), flat.px(kHair));
        if (option->rect.width() > option->rect.height())
            grip.setWidth(std::min<double>(flat.px(kSeparatorLength), option->rect.width()));
        else
            grip.setHeight(std::min<double>(flat.px(kSeparatorLength), option->rect.height()));
        grip.moveCenter(QRectF(option->rect).center());
        return flat.box(grip, flat.under() ? flat.colours().ring : flat.colours().handle, {});
    }
    default:
        break;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void ConsoleStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
    switch (element) {
    case CE_PushButtonLabel:
        if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
            button != nullptr && isFilled(option)) {
            QStyleOptionButton onAccent(*button);
            onAccent.palette.setColor(
                QPalette::ButtonText,
                controlColours(option->palette, option->state.testFlag(State_Enabled)).onAccent);
            return QProxyStyle::drawControl(element, &onAccent, painter, widget);
        }
        break;
    case CE_ComboBoxLabel:
        // Not cut off in a letter.
        if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
            box != nullptr && !box->editable) {
            QStyleOptionComboBox shown(*box);
            const int icon = box->currentIcon.isNull() ? 0 : box->iconSize.width() + kComboIcon_px;
            const int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() -
                             2 * kComboText_px - icon;
            shown.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
            return QProxyStyle::drawControl(element, &shown, painter, widget);
        }
        break;
    case CE_TabBarTabShape:
        if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option))
            return drawTab(*tab, *painter);
        break;
    case CE_MenuItem:
        if (const QStyleOptionMenuItem* section = menuSection(option)) {
            const auto in = static_cast<int>(std::lround(gridOf(option)));
            QFont font = section->font;
            font.setBold(true);
            painter->save();
            painter->setFont(font);
            painter->setPen(option->palette.color(QPalette::PlaceholderText));
            painter->drawText(option->rect.adjusted(in, in / 2, -in, 0), Qt::AlignLeft | Qt::AlignVCenter,
                              section->text);
            painter->restore();
            return;
        }
        break;
    case CE_HeaderSection: {
        const QRectF rect(option->rect);
        const ControlColours colours = controlColours(option->palette, true);
        painter->fillRect(rect, option->palette.color(QPalette::Window));
        painter->fillRect(QRectF(rect.left(), rect.bottom() - 1.0, rect.width(), 1.0), colours.edge);
        return;
    }
    case CE_HeaderEmptyArea:
        painter->fillRect(option->rect, option->palette.color(QPalette::Window));
        return;
    case CE_ProgressBarGroove:
        return ControlPainter(*painter, *option)
            .box(option->rect, controlColours(option->palette, true).groove, {});
    case CE_ProgressBarContents:
        if (const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option);
            bar != nullptr && bar->maximum > bar->minimum && bar->state.testFlag(State_Horizontal)) {
            ControlPainter flat(*painter, *option);
            const double share = std::clamp((static_cast<double>(bar->progress) - bar->minimum) /
                                                (static_cast<double>(bar->maximum) - bar->minimum),
                                            0.0, 1.0);
            QRectF done(option->rect);
            done.setWidth(share * done.width());
            if (bar->direction == Qt::RightToLeft)
                done.moveRight(option->rect.right() + 1.0);
            if (!done.isEmpty())
                flat.box(done, flat.colours().ring, {});
            return;
        }
        break;
    case CE_DockWidgetTitle:
        if (const auto* dock = qstyleoption_cast<const QStyleOptionDockWidget*>(option)) {
            QStyleOptionDockWidget titled(*dock);
            const QFont title = bold(sized(painter->font(), kTitleText));
            titled.fontMetrics = QFontMetrics(title);
            painter->save();
            painter->setFont(title);
            QProxyStyle::drawControl(element, &titled, painter, widget);
            painter->restore();
            return;
        }
        break;
    case CE_Splitter:
        return drawPrimitive(PE_IndicatorDockWidgetResizeHandle, option, painter, widget);
    default:
        break;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void ConsoleStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                      QPainter* painter, const QWidget* widget) const {
    switch (control) {
    case CC_ComboBox: {
        const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
        if (box == nullptr)
            break;
        ControlPainter flat(*painter, *option);
        if (box->frame)
            flat.field(option->rect);
        flat.chevron(subControlRect(control, option, SC_ComboBoxArrow, widget), Qt::DownArrow, flat.ink());
        return;
    }
    case CC_SpinBox: {
        const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        if (box == nullptr)
            break;
        ControlPainter flat(*painter, *option);
        if (box->frame)
            flat.field(option->rect);
        if (box->buttonSymbols == QAbstractSpinBox::NoButtons)
            return;
        for (const auto& [part, step, way] :
             {std::tuple{SC_SpinBoxUp, QAbstractSpinBox::StepUpEnabled, Qt::UpArrow},
              std::tuple{SC_SpinBoxDown, QAbstractSpinBox::StepDownEnabled, Qt::DownArrow}}) {
            const QRectF place = subControlRect(control, option, part, widget);
            const bool isActive = option->activeSubControls.testFlag(part);
            if (isActive && flat.enabled() && (flat.under() || flat.pressed()))
                flat.box(place, flat.pressed() ? flat.colours().pressed : flat.colours().groove, {}, 0.25);
            flat.chevron(place, way,
                         box->stepEnabled.testFlag(step)
                             ? flat.ink()
                             : option->palette.color(QPalette::Disabled, QPalette::WindowText));
        }
        return;
    }
    case CC_Slider: {
        const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
        if (slider == nullptr)
            break;
        if (slider->subControls.testFlag(SC_SliderTickmarks)) {
            QStyleOptionSlider ticks(*slider);
            ticks.subControls = SC_SliderTickmarks;
            QProxyStyle::drawComplexControl(control, &ticks, painter, widget);
        }
        return drawSlider(*slider, *painter, subControlRect(control, option, SC_SliderGroove, widget),
                          subControlRect(control, option, SC_SliderHandle, widget));
    }
    case CC_ScrollBar: {
        const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
        if (bar == nullptr)
            break;
        painter->fillRect(option->rect, option->palette.color(QPalette::Window));
        if (bar->maximum <= bar->minimum)
            return;
        ControlPainter flat(*painter, *option);
        QRectF handle = subControlRect(control, option, SC_ScrollBarSlider, widget);
        const double thick = flat.px(kScrollHandle);
        const double across = bar->orientation == Qt::Horizontal ? handle.height() : handle.width();
        const double in = std::max(0.0, 0.5 * (across - thick));
        handle = bar->orientation == Qt::Horizontal ? handle.adjusted(1, in, -1, -in)
                                                    : handle.adjusted(in, 1, -in, -1);
        const bool isUsed = flat.under() || flat.pressed();
        return flat.box(handle, isUsed ? flat.colours().edge : flat.colours().handle, {},
                        0.5 * kScrollHandle);
    }
    case CC_ToolButton:
        if (hasMenuArrow(option)) {
            // Text and icon to the left of the arrow, which Fusion squeezes into a corner.
            QStyleOptionToolButton plain(*qstyleoption_cast<const QStyleOptionToolButton*>(option));
            plain.features.setFlag(QStyleOptionToolButton::HasMenu, false);
            QStyleOptionToolButton panel(plain);
            panel.text.clear();
            panel.icon = QIcon();
            panel.arrowType = Qt::NoArrow;
            panel.features.setFlag(QStyleOptionToolButton::Arrow, false);
            QProxyStyle::drawComplexControl(control, &panel, painter, widget);
            const int room = static_cast<int>(std::lround(gridOf(option) * kMenuArrow));
            const bool isMirrored = option->direction == Qt::RightToLeft;
            QRect arrow = option->rect;
            plain.rect =
                isMirrored ? option->rect.adjusted(room, 0, 0, 0) : option->rect.adjusted(0, 0, -room, 0);
            if (isMirrored)
                arrow.setRight(arrow.left() + room);
            else
                arrow.setLeft(arrow.right() - room);
            QProxyStyle::drawControl(CE_ToolButtonLabel, &plain, painter, widget);
            ControlPainter flat(*painter, *option);
            return flat.chevron(arrow, Qt::DownArrow, flat.ink());
        }
        break;
    default:
        break;
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

QRect ConsoleStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                   const QWidget* widget) const {
    const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (control != CC_ScrollBar || bar == nullptr)
        return QProxyStyle::subControlRect(control, option, part, widget);
    // Without buttons at its ends: the handle has the whole way.
    const bool lies = bar->orientation == Qt::Horizontal;
    const int length = lies ? option->rect.width() : option->rect.height();
    const double range = static_cast<double>(bar->maximum) - bar->minimum;
    int handle = length;
    if (range > 0.0) {
        const int least = std::min(length, static_cast<int>(std::lround(kLeastHandle * gridOf(option))));
        const auto fair = static_cast<int>(length * (bar->pageStep / (range + bar->pageStep)));
        handle = std::clamp(fair, least, length);
    }
    const int start = sliderPositionFromValue(bar->minimum, bar->maximum, bar->sliderPosition,
                                              length - handle, bar->upsideDown);
    const auto along = [&](int from, int size) {
        const QRect place =
            lies ? QRect(from, 0, size, option->rect.height()) : QRect(0, from, option->rect.width(), size);
        return visualRect(option->direction, option->rect, place.translated(option->rect.topLeft()));
    };
    switch (part) {
    case SC_ScrollBarSlider:
        return along(start, handle);
    case SC_ScrollBarGroove:
        return along(0, length);
    case SC_ScrollBarSubPage:
        return along(0, start);
    case SC_ScrollBarAddPage:
        return along(start + handle, length - start - handle);
    default:
        return {};
    }
}

QSize ConsoleStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                     const QWidget* widget) const {
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    const auto least = static_cast<int>(std::lround(kControlHeight * gridOf(option)));
    switch (type) {
    case CT_MenuItem:
        if (const QStyleOptionMenuItem* section = menuSection(option)) {
            QFont font = section->font;
            font.setBold(true);
            return {QFontMetrics(font).horizontalAdvance(section->text) +
                        static_cast<int>(std::lround(2.0 * gridOf(option))),
                    static_cast<int>(std::lround(kSectionHeight * gridOf(option)))};
        }
        return size;
    case CT_ComboBox:
        size.rwidth() += static_cast<int>(std::lround(kComboArrow * gridOf(option)));
        return {size.width(), std::max(contents.height() + 2 * kFieldEdge_px, least)};
    case CT_PushButton:
        size.rwidth() += static_cast<int>(std::lround(kButtonMargin * gridOf(option)));
        [[fallthrough]];
    case CT_LineEdit:
        return {size.width(), std::max(contents.height() + 2 * kFieldEdge_px, least)};
    case CT_SpinBox: // around a line edit
        return {size.width(), std::max(contents.height(), least)};
    case CT_ToolButton:
        if (hasMenuArrow(qstyleoption_cast<const QStyleOptionToolButton*>(option)))
            size.rwidth() += static_cast<int>(std::lround(gridOf(option) * kMenuArrow)) -
                             pixelMetric(PM_MenuButtonIndicator, option, widget);
        return size;
    default:
        return size;
    }
}

int ConsoleStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    switch (metric) {
    case PM_ScrollBarExtent:
        return static_cast<int>(
            std::lround(kScrollExtent * (option != nullptr   ? gridOf(option)
                                         : widget != nullptr ? static_cast<double>(grid(widget))
                                                             : 8.0)));
    case PM_HeaderMargin:
    case PM_FocusFrameHMargin:
        return static_cast<int>(std::lround(kCellMargin * (widget != nullptr ? grid(widget) : 8.0))) +
               (metric == PM_HeaderMargin ? 1 : 0); // a cell adds a pixel of its own
    case PM_TabBarTabHSpace: {
        // The names of many docks have to share the width of one.
        const int space = QProxyStyle::pixelMetric(metric, option, widget);
        const bool ofDocks =
            widget != nullptr && qobject_cast<const QMainWindow*>(widget->parentWidget()) != nullptr;
        return ofDocks ? space * 2 / 3 : space;
    }
    case PM_TabBarBaseOverlap:
    case PM_TabBarTabShiftVertical:
    case PM_ButtonShiftHorizontal:
    case PM_ButtonShiftVertical:
        return 0;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int ConsoleStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                            QStyleHintReturn* returned) const {
    return hint == SH_DialogButtonBox_ButtonsHaveIcons
               ? 0
               : QProxyStyle::styleHint(hint, option, widget, returned);
}

QIcon ConsoleStyle::standardIcon(StandardPixmap icon, const QStyleOption* option,
                                 const QWidget* widget) const {
    switch (icon) {
    case SP_MessageBoxInformation:
        return themeIcon(Icon::info);
    case SP_MessageBoxQuestion:
        return themeIcon(questionMark());
    case SP_MessageBoxWarning:
        return themeIcon(Icon::warning);
    case SP_MessageBoxCritical:
        return themeIcon(Icon::error);
    default:
        return QProxyStyle::standardIcon(icon, option, widget);
    }
}

} // namespace teleta::base
