// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/pattern_library.h"

#include "backend/pattern/built_in_patterns.h"
#include "widgets/base/number_format.h"
#include "widgets/base/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace teleta::editor {

using namespace pattern;

namespace {

constexpr int kKey = Qt::UserRole;

QString lengthText(double duration_s) {
    return base::withUnit(QLocale().toString(duration_s, 'f', duration_s < 100.0 ? 2 : 0),
                          QStringLiteral("s"));
}

} // namespace

PatternLibrary::PatternLibrary(QWidget* parent)
    : QWidget(parent)
    , m_filter(new QLineEdit(this))
    , m_tree(new QTreeWidget(this)) {
    m_filter->setClearButtonEnabled(true);
    m_tree->setColumnCount(2);
    m_tree->setHeaderHidden(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setIndentation(base::em(this, 0.9));
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_filter);
    layout->addWidget(m_tree, 1);
    connect(m_filter, &QLineEdit::textChanged, this, &PatternLibrary::applyFilter);
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        const QString key = item->data(0, kKey).toString();
        if (!key.isEmpty())
            emit openRequested(key);
    });
    connect(m_tree, &QWidget::customContextMenuRequested, this, &PatternLibrary::showMenu);
    fill();
}

void PatternLibrary::setOwn(std::vector<OwnPattern> own) {
    m_own = std::move(own);
    fill();
}

void PatternLibrary::setCurrent(const QString& idOrPath) {
    if (idOrPath == m_current)
        return;
    m_current = idOrPath;
    fill();
}

void PatternLibrary::fill() {
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setAccessibleName(tr("Filter the patterns"));
    m_tree->setAccessibleName(tr("Patterns"));
    m_tree->setWhatsThis(tr("<p>Double-click opens a pattern. Built-in patterns stay as they are: the first "
                            "edit makes a copy.</p>"));
    m_tree->clear();
    const auto group = [this](const QString& name) {
        auto* item = new QTreeWidgetItem(m_tree, {name});
        QFont font = m_tree->font();
        font.setBold(true);
        item->setFont(0, font);
        item->setFlags(Qt::ItemIsEnabled);
        item->setExpanded(true);
        return item;
    };
    const auto add = [this](QTreeWidgetItem* parent, const QString& name, double duration_s,
                            const QString& key) {
        auto* item = new QTreeWidgetItem(parent, {name, lengthText(duration_s)});
        item->setData(0, kKey, key);
        item->setForeground(1, palette().color(QPalette::PlaceholderText));
        item->setToolTip(0, key);
        if (key == m_current)
            m_tree->setCurrentItem(item);
    };
    QTreeWidgetItem* shapes = group(tr("Built-in: shapes"));
    QTreeWidgetItem* stiffness = group(tr("Built-in: stiffness"));
    for (const Pattern& pattern : builtInPatterns())
        add(pattern.task == Task::shape ? shapes : stiffness, QString::fromStdString(pattern.name),
            pattern.duration_s, QString::fromStdString(pattern.id));
    QTreeWidgetItem* mine = group(tr("Mine"));
    for (const OwnPattern& own : m_own)
        add(mine, own.name, own.duration_s, own.path);
    if (m_own.empty())
        (new QTreeWidgetItem(mine, {tr("none yet: edit a built-in one")}))->setFlags(Qt::NoItemFlags);
    applyFilter();
}

void PatternLibrary::applyFilter() {
    const QString wanted = m_filter->text().trimmed();
    for (int g = 0; g < m_tree->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = m_tree->topLevelItem(g);
        bool any = wanted.isEmpty();
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem* item = group->child(i);
            const bool shown = wanted.isEmpty() || item->text(0).contains(wanted, Qt::CaseInsensitive) ||
                               item->data(0, kKey).toString().contains(wanted, Qt::CaseInsensitive);
            item->setHidden(!shown);
            any = any || shown;
        }
        group->setHidden(!any);
    }
}

void PatternLibrary::showMenu(const QPoint& at) {
    const QTreeWidgetItem* item = m_tree->itemAt(at);
    const QString key = item ? item->data(0, kKey).toString() : QString();
    if (key.isEmpty())
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Open"), this, [this, key] { emit openRequested(key); });
    menu->addAction(tr("&Duplicate"), this, [this, key] { emit duplicateRequested(key); });
    menu->addAction(tr("&Compare with It"), this, [this, key] { emit compareRequested(key); });
    menu->popup(m_tree->viewport()->mapToGlobal(at));
}

void PatternLibrary::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        fill();
}

} // namespace teleta::editor
