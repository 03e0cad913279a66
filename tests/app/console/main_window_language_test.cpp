// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/main_window.h"
#include "app/console/study/study_page.h"
#include "tests/app/console/lettered_texts.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QHash>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QSpinBox>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <memory>
#include <vector>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;

namespace {

constexpr int kPatience_ms = 20'000;
/// A text of places for numbers and names needs so many letters of its own to be known again.
constexpr int kLetters = 12;

QString withoutMnemonic(QString text) {
    static const QRegularExpression inBrackets(QStringLiteral("\\(&[A-Za-z]\\)"));
    text.remove(inBrackets);
    return text.remove(QLatin1Char('&')).trimmed();
}

struct Translated {
    QString english;
    QString french;
};

/// All texts of the program, each form of the plurals alone.
std::vector<Translated> texts() {
    QFile file(QStringLiteral(TELETA_SOURCE_DIR "/translations/teleta_fr.ts"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no translation");
    std::vector<Translated> all;
    QXmlStreamReader xml(&file);
    QString english;
    bool plural = false;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("source"))
            english = withoutMnemonic(xml.readElementText());
        else if (xml.name() == QLatin1String("message"))
            plural = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
        else if (xml.name() == QLatin1String("numerusform") ||
                 (xml.name() == QLatin1String("translation") && !plural))
            all.push_back({english, withoutMnemonic(xml.readElementText())});
    }
    return all;
}

/// Tells of a text whether it is one of a language.
class KnownTexts {
public:
    void add(const QString& text) {
        static const QRegularExpression place(QStringLiteral("%(L?[0-9]+|n)"));
        const QStringList parts = text.split(place);
        if (parts.size() == 1) {
            m_whole.insert(text);
            return;
        }
        QStringList escaped;
        for (const QString& part : parts)
            escaped << QRegularExpression::escape(part);
        const auto letters = [](const QString& part) {
            return std::count_if(part.begin(), part.end(), [](QChar c) { return c.isLetter(); });
        };
        qsizetype own = 0;
        for (const QString& part : parts)
            own += letters(part);
        if (own >= kLetters)
            m_formats.push_back(
                {parts.front(), parts.back(),
                 QRegularExpression(QRegularExpression::anchoredPattern(escaped.join(QStringLiteral(".*"))),
                                    QRegularExpression::DotMatchesEverythingOption)});
    }
    [[nodiscard]] bool has(const QString& text) const {
        return m_whole.contains(text) || std::ranges::any_of(m_formats, [&](const Format& format) {
                   return text.startsWith(format.head) && text.endsWith(format.tail) &&
                          format.whole.match(text).hasMatch();
               });
    }

private:
    /// Few texts begin and end as it does: the expression is slow.
    struct Format {
        QString head;
        QString tail;
        QRegularExpression whole;
    };
    QSet<QString> m_whole;
    std::vector<Format> m_formats;
};

QString describe(const QObject* object) {
    QStringList path;
    for (const QObject* each = object; each != nullptr && path.size() < 5; each = each->parent())
        path.prepend(QString::fromLatin1(each->metaObject()->className()) +
                     (each->objectName().isEmpty() ? QString() : QLatin1Char(' ') + each->objectName()));
    return path.join(QLatin1String(" > "));
}

/// What a message says stays as it was said.
bool isOfTheTime(const QObject* object) {
    for (const QObject* each = object; each != nullptr; each = each->parent())
        if (qobject_cast<const chrome::MessageBar*>(each) != nullptr)
            return true;
    return false;
}

} // namespace

/// No text keeps the language that was chosen before.
class MainWindowLanguageTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    core::StopSwitch m_stop;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<MainWindow> m_window;
    KnownTexts m_english;
    KnownTexts m_french;
    QHash<const KnownTexts*, QHash<QString, bool>> m_known; ///< whether a text is of this language alone

    void openWindow(const ConsoleOptions& options) {
        m_settings = std::make_unique<ConsoleSettings>(true);
        m_window = std::make_unique<MainWindow>(options, *m_settings, m_stop);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->openRequested(options);
    }

    void choose(const QString& language) const {
        for (QAction* action : m_window->findChild<QMenu*>("languages")->actions()) {
            if (action->text() == language) {
                action->trigger();
                return;
            }
        }
        QFAIL(qPrintable(language));
    }

    /// Calls with each text that somebody can read or hear, and where it is.
    template <typename Visit>
    void visitTexts(Visit visit) const {
        QSet<QObject*> objects;
        for (QWidget* window : QApplication::topLevelWidgets()) {
            objects << window;
            for (QObject* object : window->findChildren<QObject*>())
                objects << object;
        }
        for (QObject* object : objects) {
            if (isOfTheTime(object))
                continue;
            for (const char* property :
                 {"text", "title", "toolTip", "whatsThis", "statusTip", "windowTitle", "accessibleName",
                  "accessibleDescription", "placeholderText", "specialValueText", "prefix", "suffix"}) {
                const QVariant value = object->property(property);
                const bool typed =
                    qobject_cast<QLineEdit*>(object) != nullptr && property == QByteArray("text");
                if (value.metaType().id() == QMetaType::QString && !typed)
                    visit(value.toString(), object);
            }
            if (const auto* box = qobject_cast<QComboBox*>(object))
                for (int i = 0; i < box->count(); ++i)
                    visit(box->itemText(i), object);
            if (const auto* tabs = qobject_cast<QTabBar*>(object))
                for (int i = 0; i < tabs->count(); ++i) {
                    visit(tabs->tabText(i), object);
                    visit(tabs->tabToolTip(i), object);
                }
            if (const auto* model = qobject_cast<QAbstractItemModel*>(object))
                for (int column = 0; column < model->columnCount(); ++column) {
                    for (const auto role : {Qt::DisplayRole, Qt::ToolTipRole})
                        visit(model->headerData(column, Qt::Horizontal, role).toString(), object);
                    for (int row = 0; row < model->rowCount(); ++row)
                        for (const auto role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole})
                            visit(model->index(row, column).data(role).toString(), object);
                }
        }
    }

    /// Texts of a language that are not texts of the other one too.
    QStringList texts(const KnownTexts& of, const KnownTexts& notOf) {
        QHash<QString, bool>& known = m_known[&of];
        QStringList found;
        visitTexts([&](const QString& shown, const QObject* object) {
            const QString text = withoutMnemonic(shown);
            if (text.isEmpty())
                return;
            auto seen = known.find(text);
            if (seen == known.end())
                seen = known.insert(text, of.has(text) && !notOf.has(text));
            if (*seen)
                found << QLatin1Char('"') + text + QLatin1String("\" in ") + describe(object);
        });
        return found;
    }

    void seeAllPages() const {
        for (const auto key : {Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_1}) {
            QTest::keyClick(m_window.get(), key, Qt::ControlModifier);
            QCoreApplication::processEvents();
        }
    }

private slots:
    void initTestCase() {
        base::applyTheme(base::ThemeChoice::light);
        for (const Translated& one : ::texts()) {
            m_english.add(one.english);
            m_french.add(one.french);
        }
    }
    void cleanup() {
        choose(QStringLiteral("English"));
        m_window.reset();
    }

    void nothingKeepsTheLanguageBefore_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<bool>("study");
        QTest::newRow("no source") << QString() << false;
        QTest::newRow("arm, study") << QStringLiteral(":/scenes/teleta-touch.toml") << true;
        QTest::newRow("array") << QStringLiteral(":/scenes/tactile-two-contacts.toml") << false;
        QTest::newRow("servo") << QStringLiteral(":/scenes/servo-bent-bar.toml") << false;
        QTest::newRow("camera") << QStringLiteral(":/scenes/vtacarm-multicontact.toml") << false;
        QTest::newRow("teleoperation") << QStringLiteral(":/scenes/teleoperation.toml") << false;
    }
    void nothingKeepsTheLanguageBefore() {
        QFETCH(QString, scene);
        QFETCH(bool, study);
        ConsoleOptions options;
        options.dataFolder = m_folder.filePath(QString::fromLatin1(QTest::currentDataTag()));
        if (!scene.isEmpty())
            options.scenes = {scene};
        if (study) {
            options.study = m_folder.filePath(QStringLiteral("study"));
            options.rehearse = true;
        }
        openWindow(options);
        choose(QStringLiteral("English"));
        const auto showsData = [this] {
            const auto* item = m_window->sources().active();
            return item != nullptr && item->displayed > 0;
        };
        if (!scene.isEmpty())
            QTRY_VERIFY_WITH_TIMEOUT(showsData(), kPatience_ms);
        auto* page = m_window->findChild<console::StudyPage*>();
        if (study)
            QTRY_VERIFY_WITH_TIMEOUT(page->controller().overview().has_value(), kPatience_ms);
        seeAllPages();
        // Enough of them is known again for the test to mean something.
        QVERIFY(texts(m_english, m_french).size() > 300);
        choose(QStringLiteral("Fran\u00e7ais"));
        seeAllPages();
        const auto left = [this] { return texts(m_english, m_french); };
        QTRY_VERIFY2_WITH_TIMEOUT(left().isEmpty(), qPrintable('\n' + left().join('\n')), kPatience_ms);
        choose(QStringLiteral("English"));
        seeAllPages();
        const auto french = [this] { return texts(m_french, m_english); };
        QTRY_VERIFY2_WITH_TIMEOUT(french().isEmpty(), qPrintable('\n' + french().join('\n')), kPatience_ms);
    }

    void noFieldOfAPageHasTheLetterOfAMenu_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("scene");
        for (const QString& language : {QStringLiteral("English"), QStringLiteral("Fran\u00e7ais")})
            for (const QString& scene : {QStringLiteral("teleoperation"), QStringLiteral("servo-bent-bar"),
                                         QStringLiteral("vtacarm-multicontact")})
                QTest::newRow(qPrintable(language + QStringLiteral(", ") + scene)) << language << scene;
    }
    void noFieldOfAPageHasTheLetterOfAMenu() {
        QFETCH(QString, language);
        QFETCH(QString, scene);
        ConsoleOptions options;
        options.dataFolder = m_folder.filePath(QString::fromLatin1(QTest::currentDataTag()));
        options.scenes = {scene};
        openWindow(options);
        choose(language);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->sources().active() != nullptr, kPatience_ms);
        seeAllPages();
        QHash<QKeySequence, QString> menus;
        for (const QAction* menu : m_window->menuBar()->actions())
            menus.insert(QKeySequence::mnemonic(menu->text()), menu->text());
        QVERIFY(menus.size() > 4);
        int letters = 0;
        QStringList taken;
        const auto look = [&](const QString& text) {
            const QKeySequence letter = QKeySequence::mnemonic(text);
            letters += letter.isEmpty() ? 0 : 1;
            if (menus.contains(letter))
                taken << text + QStringLiteral(" as ") + menus.value(letter); // a long message is cut
        };
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            if (widget->window() != m_window.get())
                continue; // in a dialog Alt and a letter are its own
            for (const QString& text : test::letteredTexts(*widget))
                look(text);
        }
        QVERIFY(letters > 5);
        taken.removeDuplicates();
        QVERIFY2(taken.isEmpty(), qPrintable(taken.join(QStringLiteral("; "))));
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    MainWindowLanguageTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "main_window_language_test.moc"
