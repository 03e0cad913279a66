// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/loads_view.h"

#include "widgets/base/compose.h"
#include "widgets/base/controls/picture_card.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

#include <array>
#include <initializer_list>
#include <utility>

namespace teleta::calibrate {

namespace {

enum ResultColumn { loadColumn, signalColumn, gainColumn, errorColumn, fromColumn, toColumn, resultColumns };

QString number(double value) {
    constexpr int kDigits = 4; // gains of gels are large, and their signals small
    return QLocale().toString(value, 'g', kDigits);
}

constexpr QSizeF kPicture_em(24.0, 11.0);

/// What is done here: known loads over a signal, and the line through them.
void paintPresses(QPainter& painter, const QRectF& rect, const QPalette& palette) {
    const base::ControlColours colours = base::controlColours(palette, true);
    const QFont small = base::sized(painter.font(), base::kSmallText);
    const double line = QFontMetricsF(small).height();
    const QRectF axes = rect.adjusted(3.0 * line, 1.5 * line, -2.0 * line, -2.2 * line);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small);
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.drawText(QRectF(axes.left(), axes.bottom() + 0.4 * line, axes.width(), line), Qt::AlignCenter,
                     LoadsView::tr("signal"));
    painter.drawText(QRectF(rect.left(), axes.top(), axes.left() - rect.left() - 0.5 * line, line),
                     Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("N"));
    painter.setPen(QPen(palette.color(QPalette::PlaceholderText), 1.5));
    painter.drawPolyline(QPolygonF{axes.topLeft(), axes.bottomLeft(), axes.bottomRight()});
    const auto at = [&axes](double signal, double load) {
        return QPointF(axes.left() + signal * axes.width(), axes.bottom() - load * axes.height());
    };
    painter.setPen(QPen(colours.accent, 2.0));
    painter.drawLine(at(0.0, 0.02), at(0.96, 0.94));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::Text));
    constexpr std::array<std::pair<double, double>, 7> kPresses{
        {{0.06, 0.1}, {0.2, 0.19}, {0.33, 0.36}, {0.48, 0.46}, {0.6, 0.63}, {0.75, 0.72}, {0.88, 0.88}}};
    for (const auto& [signal, load] : kPresses)
        painter.drawEllipse(at(signal, load), 3.0, 3.0);
}

} // namespace

LoadsView::LoadsView(QWidget* parent)
    : CalibrationView({"undo", "redo", "load", "save"}, parent)
    , m_openText(new QLabel(this))
    , m_chooseText(new QLabel(this))
    , m_columns(base::named<QListWidget>("columns", this))
    , m_result(base::named<QTableWidget>("loads", this))
    , m_none(new base::PictureCard(this)) {
    for (QLabel* text : {m_openText, m_chooseText})
        text->setWordWrap(true);
    m_none->setPicture(paintPresses);
    m_none->setPictureHeight(base::em(this, kPicture_em.height()));
    m_none->setMaximumWidth(base::em(this, kPicture_em.width()));
    m_none->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    m_result->setColumnCount(resultColumns);
    m_result->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_result->verticalHeader()->hide();
    m_result->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);

    auto* steps = new QVBoxLayout;
    const auto add = [&](const char* name) {
        QPushButton* made = addButton(name, this);
        made->setMinimumHeight(base::em(this, 2.2));
        auto* row = new QHBoxLayout;
        row->addWidget(made);
        row->addStretch(1);
        steps->addLayout(row);
        steps->addSpacing(base::grid(this));
    };
    steps->addWidget(m_openText);
    add("presses");
    steps->addWidget(m_chooseText);
    steps->addWidget(m_columns, 1);
    add("fit");
    steps->addWidget(verdict());
    auto* picture = new QVBoxLayout;
    auto* middle = new QHBoxLayout;
    middle->addWidget(m_none);
    picture->addLayout(middle, 1);
    picture->addWidget(m_result, 1);
    auto* body = new QHBoxLayout;
    body->setSpacing(base::grid(this, 2.0));
    body->addLayout(steps, 2);
    body->addLayout(picture, 3);
    page().addLayout(body, 1);

    connect(button("presses"), &QPushButton::clicked, this, &LoadsView::pressesRequested);
    connect(button("fit"), &QPushButton::clicked, this, [this] { emit fitRequested(chosen()); });
    connect(m_columns, &QListWidget::itemChanged, this, &LoadsView::refresh);
    base::keepTranslated(this, &LoadsView::retranslate);
    base::onChange(this, &LoadsView::refresh, {QEvent::PaletteChange});
}

void LoadsView::setTable(const PressTable& table) {
    const QStringList before = chosen();
    m_table = table;
    m_trouble.clear();
    {
        const QSignalBlocker blocked(m_columns);
        m_columns->clear();
        for (const QString& column : table.columns) {
            auto* item = new QListWidgetItem(column, m_columns);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(before.contains(column) ? Qt::Checked : Qt::Unchecked);
        }
    }
    refresh();
}

QStringList LoadsView::chosen() const {
    QStringList columns;
    for (int row = 0; row < m_columns->count(); ++row)
        if (m_columns->item(row)->checkState() == Qt::Checked)
            columns << m_columns->item(row)->text();
    return columns;
}

void LoadsView::take(const LoadsFound& found) {
    const auto show = [this](const LoadsFound& shown) {
        m_trouble.clear();
        m_found = shown;
        refresh();
    };
    change([show, found] { show(found); }, [show, before = m_found] { show(before); });
}

void LoadsView::setBusy(bool busy) {
    m_busy = busy;
    if (busy)
        m_trouble.clear();
    refresh();
}

void LoadsView::showTrouble(const QString& text) {
    m_trouble = text;
    refresh();
}

StepReading LoadsView::step() const {
    if (m_busy)
        return {.state = StepState::running};
    // What could be lost counts before what went wrong, which the page says.
    if (!isSaved())
        return {.state = StepState::notSaved};
    if (!m_trouble.isEmpty())
        return {.state = StepState::failed};
    return {.state = m_found ? StepState::done : StepState::toDo};
}

void LoadsView::undo() {
    if (!m_busy)
        changes().undo();
}

void LoadsView::redo() {
    if (!m_busy)
        changes().redo();
}

QString LoadsView::describeFound() const {
    if (!m_found)
        return {};
    QStringList lines;
    for (std::size_t i = 0; i < m_found->loads.size(); ++i)
        lines << tr("%1: residual standard deviation %2.", "a load")
                     .arg(QString::fromStdString(m_found->loads[i]),
                          number(m_found->scatter[static_cast<Eigen::Index>(i)]));
    if (m_found->condition > 1.0)
        lines << tr("Condition number of the presses: %1. From %2 on, the signals cannot be told apart.")
                     .arg(number(m_found->condition), number(equilibration::kMostCondition));
    return lines.join(QLatin1Char('\n'));
}

void LoadsView::fillResult() {
    m_result->setVisible(m_found != nullptr);
    m_none->setVisible(m_found == nullptr);
    m_result->setRowCount(0);
    if (!m_found)
        return;
    const auto& found = *m_found;
    for (Eigen::Index load = 0; load < found.gain.rows(); ++load) {
        for (Eigen::Index channel = 0; channel < found.gain.cols(); ++channel) {
            const int row = m_result->rowCount();
            m_result->insertRow(row);
            const auto put = [&](int column, const QString& text) {
                auto* item = new QTableWidgetItem(text);
                if (column >= gainColumn)
                    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
                m_result->setItem(row, column, item);
            };
            put(loadColumn, QString::fromStdString(found.loads[static_cast<std::size_t>(load)]));
            put(signalColumn, QString::fromStdString(found.channels[static_cast<std::size_t>(channel)]));
            put(gainColumn, number(found.gain(load, channel)));
            put(errorColumn, number(found.error(load, channel)));
            put(fromColumn, number(found.least[channel]));
            put(toColumn, number(found.greatest[channel]));
        }
    }
}

void LoadsView::refresh() {
    const base::StatusColours& status = base::statusColours(palette());
    const bool hasTable = !m_table.name.isEmpty();
    showTitle(hasTable ? m_table.name : tr("No presses"));
    const QString state = m_busy      ? tr("computing\u2026")
                          : !m_found  ? tr("no calibration yet")
                          : isSaved() ? tr("calibration saved")
                                      : tr("calibration not saved");
    showState(state, base::Provenance::live, m_found && isSaved() ? status.live : status.stale);
    QString opened =
        tr("1. Open a table (CSV) with one row per press: the signals of the sensor, and the known load in "
           "force_n, shear_x_n, shear_y_n or moment_nm. Rows without load give the signals at rest.");
    if (hasTable)
        opened += QLatin1Char(' ') + tr("This one has %1.").arg(m_table.loads.join(QStringLiteral(", ")));
    m_openText->setText(opened);
    m_chooseText->setText(tr("2. Tick the columns that are signals."));
    verdict()->setText(m_trouble.isEmpty() ? describeFound() : m_trouble);
    base::setTextColour(verdict(), m_trouble.isEmpty() ? palette().color(QPalette::WindowText) : status.lost);
    m_columns->setEnabled(!m_busy && hasTable);
    enable("undo", !m_busy && changes().canUndo());
    enable("redo", !m_busy && changes().canRedo());
    enable("load", !m_busy);
    enable("save", !m_busy && m_found);
    enable("presses", !m_busy);
    enable("fit", !m_busy && hasTable && !chosen().isEmpty());
    fillResult();
}

void LoadsView::retranslate() {
    name("undo", tr("Undo"), tr("Undo the last change (Ctrl+Z)"));
    name("redo", tr("Redo"), tr("Redo the change undone last"));
    name("load", tr("&Load\u2026"), tr("Show a calibration from a file (CSV)"));
    name("save", tr("&Save\u2026"),
         tr("Save the calibration (CSV) for the key \u201cloads\u201d of a sensor's file and the command "
            "line"));
    name("presses", tr("&Open presses\u2026"), tr("A table (CSV) with a row for each press"));
    name("fit", tr("Find the &gains"), tr("Least squares over the presses under load"));
    m_columns->setAccessibleName(tr("Columns that may be signals"));
    m_result->setAccessibleName(tr("Gains of the signals"));
    m_result->setHorizontalHeaderLabels({tr("Load"), tr("Signal"), tr("Gain", "N per unit of a signal"),
                                         tr("Standard error"), tr("Presses from", "a signal"),
                                         tr("to", "a signal")});
    m_none->setTexts(tr("No calibration yet"),
                     tr("The newtons for one unit of each signal will be shown here."));
    setAccessibleName(tr("Calibration of a sensor to newtons"));
    refresh();
}

} // namespace teleta::calibrate
