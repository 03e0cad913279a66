// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/pattern_library.h"

#include "backend/pattern/model/built_in_patterns.h"
#include "widgets/base/controls/find_shortcut.h"
#include "widgets/base/icons.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/document/pattern_names.h"
#include "widgets/pattern/pattern_picture.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::pattern {

namespace {

constexpr int kKey = Qt::UserRole;
constexpr int kWords = Qt::UserRole + 1; ///< what the filter looks through

QString lengthText(double duration_s) {
    return base::withUnit(QLocale().toString(duration_s, 'f', duration_s < 100.0 ? 2 : 0),
                          QStringLiteral("s"));
}

constexpr QSizeF kPicture_em(3.5, 1.6);
constexpr QSizeF kSmallPicture_em(1.3, 1.3);
constexpr double kIndent_em = 0.9;
constexpr double kSmallIndent_em = 0.35;
constexpr double kMostOwn_em = 16.0;    ///< people may give a pattern a long name
constexpr double kAroundText_em = 0.75; ///< margins of the style beside picture and text

} // namespace

PatternLibrary::PatternLibrary(QWidget* parent)
    : QWidget(parent) {
    m_filter->setClearButtonEnabled(true);
    m_tree->setColumnCount(2);
    m_tree->setHeaderHidden(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setIconSize(QSize(base::em(this, kPicture_em.width()), base::em(this, kPicture_em.height())));
    m_tree->setIndentation(base::em(this, kIndent_em));
    m_tree->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->installEventFilter(this);
    base::findBy(m_filter, this);
    m_notice->setWordWrap(true);
    m_undo->setAutoDefault(false);
    auto* done = new QHBoxLayout;
    done->setContentsMargins(0, 0, 0, 0);
    done->addWidget(m_notice, 1);
    done->addWidget(m_undo);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_filter);
    layout->addWidget(m_tree, 1);
    layout->addLayout(done);
    setNotice({}, false);
    connect(m_filter, &QLineEdit::textChanged, this, &PatternLibrary::applyFilter);
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        const QString key = item->data(0, kKey).toString();
        if (!key.isEmpty() && key != m_current)
            emit openRequested(key);
    });
    // What is highlighted by a click is what plays: the click opens it. A damaged one opens only on demand,
    // with its reason.
    connect(m_tree, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
        const QString key = item->data(0, kKey).toString();
        const OwnPattern* own = ownOf(key);
        if (!key.isEmpty() && key != m_current && (!own || own->problem.isEmpty()))
            emit openRequested(key);
    });
    connect(m_tree, &QTreeWidget::currentItemChanged, this, [this] { m_wanted.clear(); });
    connect(m_tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        const OwnPattern* own = ownOf(item->data(0, kKey).toString());
        const QString name = item->text(0).trimmed();
        if (column != 0 || !own || name == own->name)
            return;
        const QString path = own->path;
        if (name.isEmpty()) {
            const QSignalBlocker quiet(m_tree);
            item->setText(0, own->name);
            return;
        }
        emit renameRequested(path, name);
    });
    connect(m_tree, &QWidget::customContextMenuRequested, this, &PatternLibrary::showMenu);
    connect(m_undo, &QPushButton::clicked, this, &PatternLibrary::undoRequested);
    base::onChange(this, &PatternLibrary::fill, {QEvent::LanguageChange, QEvent::PaletteChange});
    fill();
}

void PatternLibrary::setOwn(std::vector<OwnPattern> own) {
    m_own = std::move(own);
    m_pictures.clear();
    fill();
}

void PatternLibrary::setNotice(const QString& text, bool undoable) {
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    m_undo->setVisible(undoable);
}

const OwnPattern* PatternLibrary::ownOf(const QString& key) const {
    const auto found = std::ranges::find(m_own, key, &OwnPattern::path);
    return found == m_own.end() ? nullptr : &*found;
}

QString PatternLibrary::currentKey() const {
    const QTreeWidgetItem* item = m_tree->currentItem();
    return item ? item->data(0, kKey).toString() : QString();
}

void PatternLibrary::setCurrent(const QString& idOrPath) {
    if (idOrPath == m_current)
        return;
    // One that is not in the list leaves no other highlighted.
    m_tree->setCurrentItem(nullptr);
    m_current = m_wanted = idOrPath;
    fill();
}

bool PatternLibrary::fitPictures() {
    const auto inPixels = [this](const QSizeF& size_em) {
        return QSize(base::em(this, size_em.width()), base::em(this, size_em.height()));
    };
    int longest = 0;
    int lengths = 0;
    for (QTreeWidgetItemIterator at(m_tree); *at; ++at) {
        if ((*at)->icon(0).isNull())
            continue;
        const auto widthOf = [&](int column) {
            const bool isBold = column == 0 && (*at)->data(0, kKey).toString() == m_current;
            return QFontMetrics(isBold ? base::bold(m_tree->font()) : m_tree->font())
                .horizontalAdvance((*at)->text(column));
        };
        longest = std::max(longest, std::min(widthOf(0), base::em(this, kMostOwn_em)));
        lengths = std::max(lengths, widthOf(1));
    }
    lengths += base::em(this, kAroundText_em);
    // The longest name beside the small picture is always whole.
    m_tree->setMinimumWidth(longest + base::em(this, kSmallPicture_em.width() + 2.0 * kSmallIndent_em) +
                            2 * base::em(this, kAroundText_em) +
                            m_tree->verticalScrollBar()->sizeHint().width() + 2 * m_tree->frameWidth());
    // The viewport has its size only once it is shown.
    const int room = m_tree->contentsRect().width() - m_tree->verticalScrollBar()->sizeHint().width() -
                     longest - base::em(this, kAroundText_em);
    // Patterns are a level below their groups.
    const auto left = [&](const QSizeF& picture_em, double indent_em) {
        return room - base::em(this, picture_em.width() + 2.0 * indent_em);
    };
    // Lengths give way first, so that a longer word of another language does not shrink all pictures.
    const bool isLarge = left(kPicture_em, kIndent_em) >= 0;
    m_tree->setColumnHidden(
        1, (isLarge ? left(kPicture_em, kIndent_em) : left(kSmallPicture_em, kSmallIndent_em)) < lengths);
    const QSize size = inPixels(isLarge ? kPicture_em : kSmallPicture_em);
    if (size == m_tree->iconSize())
        return false;
    m_tree->setIconSize(size);
    m_tree->setIndentation(base::em(this, isLarge ? kIndent_em : kSmallIndent_em));
    return true;
}

void PatternLibrary::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    if (fitPictures())
        refill();
}

void PatternLibrary::fill() {
    refill();
    if (fitPictures())
        refill();
}

void PatternLibrary::refill() {
    m_filter->setPlaceholderText(tr("Filter: name, tag (Ctrl+F)"));
    m_filter->setAccessibleName(tr("Filter the patterns"));
    m_undo->setText(tr("Undo"));
    m_undo->setToolTip(tr("Undo the last change to the library (Ctrl+Z in the list)"));
    m_tree->setAccessibleName(tr("Patterns"));
    const QString keys =
        tr("<p>A click or <b>Enter</b> opens a pattern. Built-in patterns cannot be changed: the first "
           "edit creates a copy. Your own patterns: <b>F2</b> renames, <b>Ctrl+D</b> duplicates, "
           "<b>Delete</b> deletes, <b>Ctrl+Z</b> undoes that.</p>");
    m_tree->setWhatsThis(keys + tr("<p>The pattern in bold, with a bar in front of it, is open in the "
                                   "editor; keys act on the highlighted one.</p>"));
    const QSignalBlocker quiet(m_tree);
    const QString selected = currentKey();
    const int scrolled = m_tree->verticalScrollBar()->value();
    m_tree->clear();
    const auto group = [this](const QString& name) {
        auto* item = new QTreeWidgetItem(m_tree, {name});
        item->setFont(0, base::bold(m_tree->font()));
        item->setFlags(Qt::ItemIsEnabled);
        // All rows are as high as the first one.
        item->setSizeHint(0, QSize(0, m_tree->iconSize().height() + base::grid(this, base::kTight)));
        item->setExpanded(true);
        return item;
    };
    QTreeWidgetItem* shapes = group(tr("Built-in: shapes"));
    QTreeWidgetItem* stiffness = group(tr("Built-in: stiffness"));
    for (const Pattern& pattern : builtInPatterns()) {
        auto* item = new QTreeWidgetItem(pattern.task == Task::shape ? shapes : stiffness,
                                         {displayName(pattern), lengthText(pattern.duration_s)});
        item->setData(0, kKey, QString::fromStdString(pattern.id));
        item->setData(0, kWords,
                      QStringLiteral("%1 %2 %3")
                          .arg(displayName(pattern), QString::fromStdString(pattern.name),
                               QString::fromStdString(pattern.id)));
        item->setIcon(0, pictureOf(QString::fromStdString(pattern.id), pattern));
        item->setForeground(1, palette().color(QPalette::PlaceholderText));
        item->setToolTip(0, QString::fromStdString(pattern.id));
    }
    QTreeWidgetItem* mine = group(tr("Mine"));
    for (const OwnPattern& own : m_own)
        addOwn(mine, own);
    if (m_own.empty())
        (new QTreeWidgetItem(mine, {tr("none yet: edit a built-in one")}))->setFlags(Qt::NoItemFlags);
    QTreeWidgetItem* wanted = nullptr;
    for (QTreeWidgetItemIterator at(m_tree); *at; ++at) {
        const QString key = (*at)->data(0, kKey).toString();
        if (key.isEmpty())
            continue;
        if (key == m_wanted)
            wanted = *at;
        if (key == m_current) {
            (*at)->setFont(0, base::bold(m_tree->font()));
            (*at)->setToolTip(1, tr("Open in the editor"));
            (*at)->setData(0, Qt::AccessibleDescriptionRole, tr("Open in the editor"));
        }
        if (key == (selected.isEmpty() ? m_current : selected))
            m_tree->setCurrentItem(*at);
    }
    applyFilter();
    m_tree->verticalScrollBar()->setValue(scrolled);
    if (wanted == nullptr)
        return;
    m_tree->setCurrentItem(wanted);
    m_wanted.clear();
}

void PatternLibrary::addOwn(QTreeWidgetItem* group, const OwnPattern& own) {
    auto* item = new QTreeWidgetItem(
        group, {own.name, own.problem.isEmpty() ? lengthText(own.duration_s) : QString()});
    item->setData(0, kKey, own.path);
    item->setData(0, kWords, own.name + QLatin1Char(' ') + own.tags.join(QLatin1Char(' ')));
    item->setForeground(1, palette().color(QPalette::PlaceholderText));
    QStringList lines;
    if (!own.problem.isEmpty()) {
        item->setIcon(0, base::themeIcon(base::Icon::warning));
        item->setText(1, tr("damaged"));
        item->setForeground(1, base::statusColours(palette()).lost);
        lines << own.problem;
    } else if (own.pattern != nullptr) {
        item->setIcon(0, pictureOf(own.path, *own.pattern));
    }
    if (own.problem.isEmpty() && own.renamable) {
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    if (!own.tags.isEmpty())
        lines << tr("Tags: %1").arg(own.tags.join(QStringLiteral(", ")));
    if (!own.notes.isEmpty())
        lines << own.notes;
    lines << own.path;
    for (int column = 0; column < 2; ++column)
        item->setToolTip(column, lines.join(QLatin1Char('\n')));
}

QIcon PatternLibrary::pictureOf(const QString& key, const Pattern& pattern) {
    const QSize size = m_tree->iconSize();
    const double scale = devicePixelRatioF();
    if (const PictureStyle style{size, scale, palette().cacheKey()}; style != m_pictureStyle) {
        m_pictureStyle = style;
        m_pictures.clear();
    }
    const bool isOpen = m_current == key;
    QIcon& icon = m_pictures[{key, isOpen}];
    if (!icon.isNull())
        return icon;
    // In a selected row it has the colours of that row's text.
    QPalette selected = palette();
    selected.setColor(QPalette::Base, palette().color(QPalette::Highlight));
    for (const QPalette::ColorRole role : {QPalette::Text, QPalette::Link})
        selected.setColor(role, palette().color(QPalette::HighlightedText));
    for (const auto& [mode, colours] : {std::pair(QIcon::Normal, palette()), {QIcon::Selected, selected}}) {
        QPixmap picture(QSizeF(QSizeF(size) * scale).toSize());
        picture.setDevicePixelRatio(scale);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        const int bar = base::grid(this, base::kStripe);
        const QSize room(size.width() - 2 * bar, size.height() - bar);
        painter.drawImage(QRectF(QPointF(2.0 * bar, 0.5 * bar), QSizeF(room)),
                          patternPicture(pattern, QSizeF(QSizeF(room) * scale).toSize(), colours));
        if (isOpen)
            painter.fillRect(QRectF(0.0, 0.5 * bar, bar, room.height()), colours.color(QPalette::Link));
        painter.end();
        icon.addPixmap(picture, mode);
    }
    return icon;
}

void PatternLibrary::applyFilter() {
    const QStringList wanted = m_filter->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int g = 0; g < m_tree->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = m_tree->topLevelItem(g);
        bool any = wanted.isEmpty();
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem* item = group->child(i);
            const QString words = item->data(0, kWords).toString();
            const bool shown = std::ranges::all_of(
                wanted, [&words](const QString& word) { return words.contains(word, Qt::CaseInsensitive); });
            item->setHidden(!shown);
            any = any || shown;
        }
        group->setHidden(!any);
    }
}

void PatternLibrary::rename(const QString& key) {
    const OwnPattern* own = ownOf(key);
    if (!own || !own->problem.isEmpty() || !own->renamable)
        return;
    for (QTreeWidgetItemIterator at(m_tree); *at; ++at) {
        if ((*at)->data(0, kKey).toString() == key) {
            m_tree->editItem(*at, 0);
            return;
        }
    }
}

void PatternLibrary::showMenu(const QPoint& at) {
    QTreeWidgetItem* item = m_tree->itemAt(at);
    const QString key = item ? item->data(0, kKey).toString() : QString();
    if (key.isEmpty())
        return;
    const OwnPattern* own = ownOf(key);
    const bool sound = !own || own->problem.isEmpty();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [menu, this](const QString& text, const QKeySequence& keys, bool enabled, auto act) {
        QAction* action = menu->addAction(text, this, act);
        action->setShortcut(keys); // for display only: the list handles the keys itself
        action->setShortcutContext(Qt::WidgetShortcut);
        action->setEnabled(enabled);
    };
    add(tr("&Open"), Qt::Key_Return, true, [this, key] { emit openRequested(key); });
    add(tr("&Compare with it"), {}, sound, [this, key] { emit compareRequested(key); });
    add(tr("&Duplicate"), Qt::CTRL | Qt::Key_D, sound, [this, key] { emit duplicateRequested(key); });
    if (own) {
        add(tr("&Rename"), Qt::Key_F2, sound && own->renamable, [this, key] { rename(key); });
        add(tr("De&lete"), Qt::Key_Delete, true, [this, key] { emit deleteRequested(key); });
    }
    menu->popup(m_tree->viewport()->mapToGlobal(at));
}

bool PatternLibrary::eventFilter(QObject* watched, QEvent* event) {
    const bool override = event->type() == QEvent::ShortcutOverride;
    if (watched != m_tree || (!override && event->type() != QEvent::KeyPress))
        return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const QString chosen = currentKey();
    const bool own = ownOf(chosen) != nullptr;
    // The editor uses Ctrl+Z and Ctrl+D as well; in the list they act on the list.
    const auto take = [&](auto act) {
        if (override)
            event->accept();
        else
            act();
        return true;
    };
    if (key->matches(QKeySequence::Undo))
        return take([this] { emit undoRequested(); });
    if (key->key() == Qt::Key_D && key->modifiers() == Qt::ControlModifier && !chosen.isEmpty())
        return take([&] { emit duplicateRequested(chosen); });
    if (key->key() == Qt::Key_Delete && own)
        return take([&] { emit deleteRequested(chosen); });
    if (key->key() == Qt::Key_F2 && own)
        return take([&] { rename(chosen); });
    return QWidget::eventFilter(watched, event);
}

} // namespace teleta::pattern
