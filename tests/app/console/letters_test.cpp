// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_service.h"
#include "app/console/bracelet/latency_dialog.h"
#include "app/console/calibrate/camera/live_probing_dialog.h"
#include "app/console/console_options.h"
#include "app/console/desktop/preferences_dialog.h"
#include "app/console/language_menu.h"
#include "app/console/patterns/export_dialog.h"
#include "app/console/patterns/import_dialog.h"
#include "app/console/sources/camera_dialog.h"
#include "app/console/sources/frame_dialog.h"
#include "app/console/sources/recording_dialog.h"
#include "app/console/study/forms/deletion_dialog.h"
#include "app/console/study/forms/new_study_dialog.h"
#include "app/console/study/forms/protocol_dialog.h"
#include "app/console/study/forms/protocol_reading.h"
#include "app/console/study/forms/server_study_dialog.h"
#include "app/console/study/study_page.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/study/protocol/protocol.h"
#include "tests/app/console/lettered_texts.h"
#include "tests/app/console/window_bench.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QMap>
#include <QSet>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <memory>

using namespace teleta;

namespace {

constexpr int kPatience_ms = 20'000;

const QStringList kLanguages{QStringLiteral("en"), QStringLiteral("fr")};

/// What the desktop of Debian underlines in Qt's own buttons.
QString textOnGnome(QDialogButtonBox::StandardButton button, const QString& text) {
    switch (button) {
    case QDialogButtonBox::Ok:
        return QCoreApplication::translate("QGnomeTheme", "&OK");
    case QDialogButtonBox::Save:
        return QCoreApplication::translate("QGnomeTheme", "&Save");
    case QDialogButtonBox::Cancel:
        return QCoreApplication::translate("QGnomeTheme", "&Cancel");
    case QDialogButtonBox::Close:
        return QCoreApplication::translate("QGnomeTheme", "&Close");
    default:
        return text;
    }
}

const QDockWidget* dockOf(const QWidget* widget) {
    for (const QWidget* each = widget; each != nullptr; each = each->parentWidget())
        if (const auto* dock = qobject_cast<const QDockWidget*>(each))
            return dock;
    return nullptr;
}

/// Texts by letters, of what is seen of a window: of one of its docks and of what belongs to none, or only
/// of the latter.
QMap<QString, QStringList> lettersIn(const QWidget& window, const QDockWidget* dock) {
    QMap<QString, QStringList> texts;
    const auto look = [&](const QString& text) {
        const QKeySequence letter = QKeySequence::mnemonic(text);
        if (!letter.isEmpty())
            texts[letter.toString()] << text;
    };
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        const QDockWidget* own = dockOf(widget);
        if (!widget->isVisible() || widget->window() != &window || (own != nullptr && own != dock))
            continue;
        auto* button = qobject_cast<QAbstractButton*>(widget);
        const auto* box = qobject_cast<const QDialogButtonBox*>(widget->parentWidget());
        for (const QString& text : test::letteredTexts(*widget))
            look(button != nullptr && box != nullptr ? textOnGnome(box->standardButton(button), text) : text);
    }
    return texts;
}

} // namespace

/// Alt and a letter lead to one field or button of what is seen.
class LettersTest : public QObject, protected test::WindowBench {
    Q_OBJECT

    QTemporaryDir m_folder;
    QSet<QString> m_repeated;
    int m_letters = 0;
    core::StopSwitch m_switch;
    console::BraceletService m_station{m_switch};

    void look(const QWidget& window) {
        QList<const QDockWidget*> docks{nullptr};
        for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
            if (dock->isVisible())
                docks << dock;
        for (const QDockWidget* dock : docks) {
            const auto texts = lettersIn(window, dock);
            m_letters += static_cast<int>(texts.size());
            for (auto it = texts.begin(); it != texts.end(); ++it)
                if (it->size() > 1)
                    m_repeated << (dock != nullptr ? dock->objectName() + QStringLiteral(": ") : QString()) +
                                      it->join(QStringLiteral(" | "));
        }
    }

    /// Looks at each of the tabs in turn.
    void lookAtTabs(const QWidget& window, QSet<const QTabBar*> known = {}) {
        QCoreApplication::processEvents();
        look(window);
        QList<QTabBar*> bars;
        for (QTabBar* bar : window.findChildren<QTabBar*>())
            if (bar->isVisible() && bar->window() == &window && !known.contains(bar))
                bars << bar;
        known.unite(QSet<const QTabBar*>(bars.begin(), bars.end()));
        for (QTabBar* bar : bars) {
            const int first = bar->currentIndex();
            for (int tab = 0; tab < bar->count(); ++tab) {
                bar->setCurrentIndex(tab);
                lookAtTabs(window, known);
            }
            bar->setCurrentIndex(first);
        }
    }

    void verify() {
        QVERIFY(m_letters > 0);
        QVERIFY2(m_repeated.isEmpty(),
                 qPrintable('\n' + QStringList(m_repeated.begin(), m_repeated.end()).join('\n')));
    }

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void init() {
        m_repeated.clear();
        m_letters = 0;
    }
    void cleanup() {
        m_window.reset();
        console::useLanguage(*qApp, QStringLiteral("en"));
    }

    void noLetterStandsTwiceOnAPage_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("scene");
        for (const QString& language : kLanguages)
            for (const QString& scene :
                 {QString(), QStringLiteral("teleta-touch"), QStringLiteral("teleoperation"),
                  QStringLiteral("tactile-two-contacts"), QStringLiteral("servo-bent-bar"),
                  QStringLiteral("vtacarm-multicontact"), QStringLiteral("gel-shear")})
                QTest::addRow("%s, %s", qPrintable(language), qPrintable(scene)) << language << scene;
    }
    void noLetterStandsTwiceOnAPage() {
        QFETCH(QString, language);
        QFETCH(QString, scene);
        console::useLanguage(*qApp, language);
        console::ConsoleOptions options;
        options.dataFolder = m_folder.filePath(QString::fromLatin1(QTest::currentDataTag()));
        const bool bare = scene.isEmpty();
        if (bare) {
            options.study = m_folder.filePath(language);
            options.rehearse = true;
        } else {
            options.scenes = {scene};
        }
        openWindow(options);
        if (bare) {
            const auto& study = m_window->findChild<console::StudyPage*>()->controller();
            QTRY_VERIFY_WITH_TIMEOUT(study.overview().has_value(), kPatience_ms);
        } else {
            const auto showsData = [this] {
                const auto* item = m_window->sources().active();
                return item != nullptr && item->displayed > 0;
            };
            QTRY_VERIFY_WITH_TIMEOUT(showsData(), kPatience_ms);
        }
        const int pages = bare ? static_cast<int>(console::pageNames().size()) : 1;
        for (int page = 0; page < pages; ++page) {
            QTest::keyClick(m_window.get(), static_cast<Qt::Key>(Qt::Key_1 + page), Qt::ControlModifier);
            lookAtTabs(*m_window);
        }
        verify();
    }

    void noLetterStandsTwiceInADialog_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("name");
        for (const QString& language : kLanguages)
            for (const QString& name : dialogs().keys())
                QTest::addRow("%s, %s", qPrintable(language), qPrintable(name)) << language << name;
    }
    void noLetterStandsTwiceInADialog() {
        QFETCH(QString, language);
        QFETCH(QString, name);
        console::useLanguage(*qApp, language);
        const std::unique_ptr<QDialog> dialog = dialogs().value(name)();
        dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog.get()));
        lookAtTabs(*dialog);
        verify();
    }

private:
    using Make = std::function<std::unique_ptr<QDialog>()>;

    static std::unique_ptr<QDialog> importDialog() {
        const auto read = pattern::patternFromAhap(
            R"({"Version": 1.0, "Pattern": [{"Event": {"Time": 0.5, "EventType": "HapticTransient",
            "EventParameters": [{"ParameterID": "HapticSharpness", "ParameterValue": 1.0}]}}]})",
            "tap.ahap", {});
        if (!read)
            qFatal("no pattern");
        return std::make_unique<console::ImportDialog>(QStringLiteral("tap.ahap"), *read);
    }

    QMap<QString, Make> dialogs() {
        const auto noCameras = [] { return std::vector<camera::CameraInfo>(); };
        QMap<QString, Make> all{
            {QStringLiteral("camera"),
             [=] {
                 return std::make_unique<console::CameraDialog>(app::CameraRequest(), nullptr, noCameras);
             }},
            {QStringLiteral("deletion"),
             [] { return std::make_unique<console::DeletionDialog>(QStringLiteral("P1")); }},
            {QStringLiteral("export"),
             [] {
                 return std::make_unique<console::ExportDialog>(pattern::assumedMotors(),
                                                                QStringLiteral("x"));
             }},
            {QStringLiteral("frames"),
             [] {
                 return std::make_unique<console::FrameDialog>(frames::FrameRequest(), QStringLiteral("why"));
             }},
            {QStringLiteral("import"), importDialog},
            {QStringLiteral("latency"),
             [this] { return std::make_unique<console::LatencyDialog>(m_station, nullptr); }},
            {QStringLiteral("preferences"),
             [] {
                 return std::make_unique<console::PreferencesDialog>(
                     console::Preferences(), console::languageChoices(), QStringLiteral("/usual"), nullptr);
             }},
            {QStringLiteral("probing"),
             [=] {
                 return std::make_unique<console::LiveProbingDialog>(QString(), vision::HoleGrid(), nullptr,
                                                                     noCameras);
             }},
            {QStringLiteral("recording"),
             [] { return std::make_unique<console::RecordingDialog>(app::CsvRequest()); }},
            {QStringLiteral("study on a server"),
             [] { return std::make_unique<console::ServerStudyDialog>(QStringLiteral("studies")); }}};
        const auto protocols = study::builtInProtocols();
        if (!protocols)
            qFatal("no protocols");
        for (const study::Protocol& protocol : *protocols) {
            const QString name = QString::fromStdString(protocol.name);
            all.insert(QStringLiteral("protocol ") + name,
                       [protocol] { return std::make_unique<console::ProtocolDialog>(protocol); });
            all.insert(QStringLiteral("reading ") + name,
                       [protocol] { return std::make_unique<console::ProtocolReading>(protocol); });
            all.insert(QStringLiteral("new study ") + name, [protocol] {
                return std::make_unique<console::NewStudyDialog>(protocol, QStringLiteral("studies"));
            });
        }
        return all;
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    LettersTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "letters_test.moc"
