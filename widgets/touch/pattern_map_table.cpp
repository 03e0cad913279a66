// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/pattern_map_table.h"

#include "backend/core/data/input_file.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/stiffness/material.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/icons.h"
#include "widgets/base/on_change.h"
#include "widgets/base/redo_keys.h"
#include "widgets/base/theme.h"
#include "widgets/base/undo_step.h"
#include "widgets/touch/touch_texts.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::touch {

using pattern::PatternMap;

namespace {

enum Column { kRecognised, kPattern, kPreview, kColumns };
constexpr int kLevels = static_cast<int>(pattern::kStiffnessLevels);
constexpr int kUnknownStiffness = PatternMapTable::kRows - 1;

/// Id of the pattern of a row.
template <typename Map>
auto& idOf(Map& map, int row) {
    const auto index = static_cast<std::size_t>(row);
    if (row == kUnknownStiffness)
        return map.unknownStiffness;
    return row < kLevels ? map.stiffness[index] : map.shape[index - pattern::kStiffnessLevels];
}

core::Unexpected fileError(const QString& path, const QString& message, const QString& reason) {
    return core::Unexpected(core::Error{
        core::ErrorKind::ioFailed, message.arg(reason).toStdString(), {}, {path.toStdString(), 0, 0}});
}

} // namespace

PatternMapTable::PatternMapTable(QWidget* parent)
    : QWidget(parent)
    , m_undo(new QUndoStack(this))
    , m_table(new QTableWidget(kRows, kColumns, this))
    , m_now(new QLabel(this))
    , m_undoButton(new QPushButton(this))
    , m_redoButton(new QPushButton(this))
    , m_reset(new QPushButton(this))
    , m_import(new QPushButton(this))
    , m_export(new QPushButton(this)) {
    m_now->setWordWrap(true);
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setFocusPolicy(Qt::NoFocus);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(base::em(this, 1.9));
    // What was chosen is read before anything else; the kind is shown where there is room for all of it.
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    for (int row = 0; row < kRows; ++row) {
        m_table->setItem(row, kRecognised, new QTableWidgetItem);
        m_table->setItem(row, kPreview, new QTableWidgetItem);
        auto* box = new QComboBox(m_table);
        box->setFocusPolicy(Qt::StrongFocus);
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        box->setMaximumWidth(base::em(this, 18));
        box->installEventFilter(this);
        connect(box, &QComboBox::activated, this,
                [this, row, box](int index) { choose(row, box->itemData(index).toString().toStdString()); });
        m_table->setCellWidget(row, kPattern, box);
        m_boxes.push_back(box);
    }
    // In two rows: in one they would be wider than everything else beside the pictures.
    auto* buttons = new QGridLayout;
    int place = 0;
    for (QPushButton* button : {m_undoButton, m_redoButton, m_reset, m_import, m_export}) {
        button->setAutoDefault(false);
        buttons->addWidget(button, place < 2 ? 0 : 1, place < 2 ? place : place - 2);
        ++place;
    }
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_now);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);

    const auto step = [this](QPushButton* button, void (QUndoStack::*act)(), void (QUndoStack::*can)(bool),
                             const QList<QKeySequence>& keys) {
        button->setEnabled(false);
        connect(button, &QPushButton::clicked, m_undo, act);
        connect(m_undo, can, button, &QPushButton::setEnabled);
        auto* shortcut = new QShortcut(this);
        shortcut->setKeys(keys);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, m_undo, act);
    };
    step(m_undoButton, &QUndoStack::undo, &QUndoStack::canUndoChanged,
         QKeySequence::keyBindings(QKeySequence::Undo));
    step(m_redoButton, &QUndoStack::redo, &QUndoStack::canRedoChanged, base::redoKeys());
    connect(m_reset, &QPushButton::clicked, this, &PatternMapTable::resetToDefaults);
    connect(m_import, &QPushButton::clicked, this, [this] { askForFile(false); });
    connect(m_export, &QPushButton::clicked, this, [this] { askForFile(true); });
    base::keepTranslated(this, &PatternMapTable::retranslate);
    base::onChange(this, &PatternMapTable::showRecognised, {QEvent::PaletteChange});
}

QString PatternMapTable::rowName(int row) {
    if (row < kLevels) {
        const stiffness::Material material =
            stiffness::materialBands()[static_cast<std::size_t>(row)].material;
        return tr("level %1: %2").arg(row + 1).arg(TouchTexts::material(material));
    }
    if (row == kUnknownStiffness)
        return tr("unknown stiffness");
    return TouchTexts::shape(static_cast<contour::Shape>(row - kLevels));
}

void PatternMapTable::retranslate() {
    setAccessibleName(tr("What was recognised and its pattern"));
    setWhatsThis(tr("<p>Which pattern the bracelet plays for what was recognised. The marked row was "
                    "recognised last.</p>"));
    m_table->setAccessibleName(tr("Patterns for what was recognised"));
    m_table->setHorizontalHeaderLabels({tr("Recognised"), tr("Pattern"), tr("Kind")});
    m_undoButton->setText(tr("&Undo"));
    m_redoButton->setText(tr("Red&o"));
    m_reset->setText(tr("&Defaults"));
    m_reset->setToolTip(tr("The built-in dynamic patterns again; can be undone"));
    m_import->setText(tr("&Import…"));
    m_export->setText(tr("&Export…"));
    for (int row = 0; row < kRows; ++row)
        box(row)->setAccessibleName(tr("Pattern for %1").arg(rowName(row)));
    fillBoxes();
}

void PatternMapTable::fillBoxes() {
    for (QComboBox* box : m_boxes) {
        const QSignalBlocker blocker(box);
        box->clear();
        box->addItem(tr("nothing"), QString());
        for (const PatternChoice& choice : m_choices)
            box->addItem(choice.name, QString::fromStdString(choice.id));
    }
    showMap();
}

void PatternMapTable::setChoices(std::vector<PatternChoice> choices) {
    m_choices = std::move(choices);
    fillBoxes();
}

void PatternMapTable::setMap(const PatternMap& map) {
    m_undo->clear();
    m_map = map;
    showMap();
}

const PatternChoice* PatternMapTable::choiceOf(const std::string& id) const {
    const auto found = std::ranges::find(m_choices, id, &PatternChoice::id);
    return found == m_choices.end() ? nullptr : &*found;
}

void PatternMapTable::showMap() {
    for (int row = 0; row < kRows; ++row) {
        const QString wanted = QString::fromStdString(idOf(m_map, row));
        QComboBox* choices = box(row);
        const QSignalBlocker blocker(choices);
        int index = choices->findData(wanted);
        if (index < 0) {
            // A pattern of somebody's own that is not here now stays in the map.
            choices->addItem(tr("%1 (missing)").arg(wanted), wanted);
            index = choices->count() - 1;
        }
        choices->setCurrentIndex(index);
        const PatternChoice* choice = choiceOf(idOf(m_map, row));
        const QString preview = choice ? tr("%1, %2").arg(choice->task, choice->condition) : QString();
        m_table->item(row, kPreview)->setText(preview);
        m_table->item(row, kPreview)->setToolTip(preview);
        choices->setToolTip(preview);
    }
    showRecognised();
    showKinds();
}

void PatternMapTable::showKinds() {
    int room = m_table->viewport()->width();
    for (const int column : {kRecognised, kPreview})
        room -= std::max(static_cast<QAbstractItemView*>(m_table)->sizeHintForColumn(column),
                         m_table->horizontalHeader()->sectionSizeHint(column));
    for (const QComboBox* box : m_boxes)
        if (box->sizeHint().width() > room)
            room = -1;
    m_table->setColumnHidden(kPreview, room < 0);
}

void PatternMapTable::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    showKinds();
}

void PatternMapTable::showRecognised() {
    const QColor ground = palette().color(QPalette::Base);
    const QBrush marked(base::mixed(ground, palette().color(QPalette::Highlight), 0.3));
    for (int row = 0; row < kRows; ++row) {
        const bool now = m_recognised == row;
        QTableWidgetItem* name = m_table->item(row, kRecognised);
        name->setText(now ? tr("%1 (now)").arg(rowName(row)) : rowName(row));
        name->setIcon(now ? base::themeIcon(base::Icon::play) : QIcon());
        QFont font = m_table->font();
        font.setBold(now);
        for (const int column : {kRecognised, kPreview}) {
            m_table->item(row, column)->setFont(font);
            m_table->item(row, column)->setBackground(now ? marked : QBrush());
        }
    }
    m_now->setText(textNow());
}

std::string PatternMapTable::patternNow() const {
    return m_recognised ? idOf(m_map, *m_recognised) : std::string();
}

QString PatternMapTable::textNow() const {
    if (!m_recognised)
        return tr("Nothing was recognised yet.");
    const std::string now = patternNow();
    if (now.empty())
        return tr("Recognised: %1. Nothing is played.").arg(rowName(*m_recognised));
    const PatternChoice* choice = choiceOf(now);
    const QString name = QString::fromStdString(now);
    return choice ? tr("Recognised: %1. Pattern now: %2.").arg(rowName(*m_recognised), choice->name)
                  : tr("Recognised: %1. Its pattern %2 is missing.").arg(rowName(*m_recognised), name);
}

void PatternMapTable::recognise(std::optional<int> row) {
    m_recognised = row;
    showRecognised();
}

void PatternMapTable::setRecognisedStiffness(int level) {
    recognise(level >= 1 && level <= kLevels ? std::optional(level - 1) : std::nullopt);
}

void PatternMapTable::setRecognisedShape(contour::Shape shape) {
    recognise(kLevels + static_cast<int>(shape));
}

void PatternMapTable::setUnknownStiffness() {
    recognise(kUnknownStiffness);
}

void PatternMapTable::take(const PatternMap& map) {
    m_map = map;
    showMap();
    emit mapChanged();
}

void PatternMapTable::edit(const PatternMap& map, const QString& what) {
    // The whole map, which is small, so that every edit undoes in the same way.
    if (map != m_map)
        m_undo->push(new base::UndoStep(
            what, [this, map] { take(map); }, [this, before = m_map] { take(before); }));
}

void PatternMapTable::choose(int row, const std::string& id) {
    PatternMap map = m_map;
    idOf(map, row) = id;
    edit(map, tr("Pattern for %1").arg(rowName(row)));
}

void PatternMapTable::resetToDefaults() {
    edit(PatternMap::defaults(), tr("Default patterns"));
}

core::Expected<void> PatternMapTable::importFrom(const QString& path) {
    TELETA_TRY(const std::string text, core::readFile(path.toStdString()));
    TELETA_TRY(const auto map, pattern::patternMapFromJson(text, path.toStdString()));
    edit(map, tr("Import"));
    return {};
}

core::Expected<void> PatternMapTable::exportTo(const QString& path) const {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return fileError(path, tr("The file could not be written: %1"), file.errorString());
    file.write(QByteArray::fromStdString(pattern::patternMapToJson(m_map)));
    if (!file.commit())
        return fileError(path, tr("The file could not be written: %1"), file.errorString());
    return {};
}

void PatternMapTable::askForFile(bool save) {
    const auto ask = save ? &base::askToSave : &base::askToOpen;
    const base::FileQuestion question{.title = save ? tr("Export patterns") : tr("Import patterns"),
                                      .filters = {tr("Map of patterns (*.json)")},
                                      .suffix = QStringLiteral("json")};
    ask(this, question, [this, save](const QString& path) {
        const auto result = save ? exportTo(path) : importFrom(path);
        if (!result)
            emit failed(QString::fromStdString(core::describe(result.error())));
        else if (save)
            emit exported(QDir::toNativeSeparators(path));
    });
}

bool PatternMapTable::eventFilter(QObject* watched, QEvent* event) {
    // A wheel scrolls the table; over a closed box it would change the map unseen.
    if (event->type() == QEvent::Wheel && qobject_cast<QComboBox*>(watched)) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace teleta::touch
