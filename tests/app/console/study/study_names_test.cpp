// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/study/study_bench.h"
#include "widgets/study/participant/answer_button.h"
#include "widgets/study/study_names.h"

#include <QCoreApplication>
#include <QLabel>
#include <QScopeGuard>
#include <QTranslator>

using namespace teleta;
using study::displayCondition;
using study::displayName;
using test::kPatience_ms;

namespace {

/// A language with the names of studies in brackets.
class Brackets : public QTranslator {
public:
    [[nodiscard]] QString translate(const char* context, const char* source, const char* /*note*/,
                                    int /*number*/) const override {
        return qstrcmp(context, "StudyNames") == 0 ? QStringLiteral("<%1>").arg(QLatin1String(source))
                                                   : QString();
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

} // namespace

/// Names that participants see, of built-in protocols and of others.
class StudyNamesTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    Brackets m_language;

private slots:
    void init() { setUp(); }
    void cleanup() {
        QCoreApplication::removeTranslator(&m_language);
        tearDown();
    }

    void everyNameThatComesWithTheProgramIsInTheLanguage() {
        QCoreApplication::installTranslator(&m_language);
        const auto inBrackets = [](const std::string& name) {
            return QStringLiteral("<%1>").arg(QString::fromStdString(name));
        };
        const auto protocols = study::builtInProtocols();
        QVERIFY(protocols.has_value());
        for (const study::Protocol& protocol : *protocols) {
            for (const study::StudyTask& task : protocol.tasks) {
                QCOMPARE(displayName(task), inBrackets(task.name));
                for (const std::string& condition : task.conditions)
                    QCOMPARE(displayCondition(task, condition), inBrackets(condition));
                for (const study::StudyPattern& pattern : task.patterns)
                    QCOMPARE(displayName(task, pattern), inBrackets(pattern.name));
            }
        }
    }

    void whatSomebodyHasWrittenStaysAsItIs() {
        QCoreApplication::installTranslator(&m_language);
        study::StudyTask task = study::paperProtocol()->tasks[0];
        task.patterns[0].name = "ring";
        QCOMPARE(displayName(task, task.patterns[0]), QStringLiteral("ring"));
        task.name = "What is it?";
        QCOMPARE(displayName(task), QStringLiteral("What is it?"));
        task.id = "outline";
        QCOMPARE(displayName(task, task.patterns[1]), QStringLiteral("rectangle"));
        QCOMPARE(displayCondition(task, "static"), QStringLiteral("static"));
    }

    void theFolderIsShownFromTheHomeOfTheUser() {
        openStudy();
        const auto* folder = m_page->findChild<QLabel*>(QStringLiteral("folder"));
        QCOMPARE(folder->text(), studyFolder());
        const QByteArray home = qgetenv("HOME");
        const auto goBack = qScopeGuard([&] { qputenv("HOME", home); });
        tearDown();
        setUp();
        qputenv("HOME", m_folder->path().toUtf8());
        openStudy();
        folder = m_page->findChild<QLabel*>(QStringLiteral("folder"));
        QCOMPARE(folder->text(), QLatin1Char('~') + studyFolder().sliced(m_folder->path().size()));
        QCOMPARE(folder->toolTip(), studyFolder());
    }

    void theAnswersFollowTheLanguageInMidSessionAndTheStudyDoesNot() {
        openStudy();
        beginSession();
        QTRY_COMPARE_WITH_TIMEOUT(window()->buttons().size(), std::size_t(2), kPatience_ms);
        const auto first = [this] { return window()->buttons()[0]->accessibleName(); };
        QVERIFY2(first().endsWith(QStringLiteral(": circle")), qPrintable(first()));
        QCoreApplication::installTranslator(&m_language);
        QTRY_VERIFY2_WITH_TIMEOUT(first().endsWith(QStringLiteral(": <circle>")), qPrintable(first()),
                                  kPatience_ms);
        QCOMPARE(window()->scene().title, QStringLiteral("<Object shape>"));
        QVERIFY2(sessionPanel().scene().title.contains(QStringLiteral("<Object shape>, <")),
                 qPrintable(sessionPanel().scene().title));
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        const auto store = study::StudyStore::open(studyFolder().toStdString());
        QVERIFY(store.has_value());
        QCOMPARE(store->head().protocol.tasks[0].name, std::string("Object shape"));
        QCOMPARE(store->head().protocol.tasks[0].patterns[0].name, std::string("circle"));
    }
};

QTEST_MAIN(StudyNamesTest)
#include "study_names_test.moc"
