// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using teleta::console::AtStart;
using teleta::console::Preferences;
using teleta::console::PreferencesDialog;

namespace {

const Preferences kSome{.language = "fr",
                        .theme = "dark",
                        .recordingFolder = "/data/run",
                        .atStart = AtStart::nothing,
                        .keepsScreenOn = false,
                        .exportsUtc = true};

} // namespace

class PreferencesDialogTest : public QObject {
    Q_OBJECT

    static std::unique_ptr<PreferencesDialog> shown(const Preferences& now) {
        auto dialog = std::make_unique<PreferencesDialog>(
            now, std::vector<std::pair<QString, QString>>{{"English", "en"}, {"Français", "fr"}}, "/usual",
            nullptr);
        dialog->show();
        if (!QTest::qWaitForWindowExposed(dialog.get()))
            qFatal("not shown");
        return dialog;
    }

private slots:
    void showsWhatIsSetAndGivesItBackUnchanged() {
        const auto dialog = shown(kSome);
        QVERIFY(dialog->preferences() == kSome);
        QCOMPARE(dialog->findChild<QLineEdit*>("recordingFolder")->placeholderText(), QString("/usual"));
        const Preferences unknown{.language = "tlh", .theme = "pink"};
        const auto other = shown(unknown);
        QCOMPARE(other->preferences().language, QString());
        QCOMPARE(other->preferences().theme, QString("system"));
    }

    void isFilledInByKeyboardAlone() {
        const auto dialog = shown({.theme = "system"});
        QSignalSpy accepted(dialog.get(), &QDialog::accepted);
        auto* language = dialog->findChild<QComboBox*>("language");
        language->setFocus();
        QTest::keyClick(language, Qt::Key_Down);
        QTest::keyClick(language, Qt::Key_Down);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
        QCOMPARE(dialog->focusWidget(), dialog->findChild<QComboBox*>("theme"));
        QTest::keyClick(dialog->focusWidget(), Qt::Key_End);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
        QCOMPARE(dialog->focusWidget(), dialog->findChild<QComboBox*>("atStart"));
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Down);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
        QTest::keyClicks(dialog->focusWidget(), "/data/new");
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Space);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Space);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Return);
        QCOMPARE(accepted.count(), 1);
        const Preferences wanted{.language = "fr",
                                 .theme = "dark",
                                 .recordingFolder = "/data/new",
                                 .atStart = AtStart::open,
                                 .keepsScreenOn = false,
                                 .exportsUtc = true};
        QVERIFY(dialog->preferences() == wanted);
    }

    void defaultsAreShownAndTakenOnlyWhenAccepted() {
        const auto dialog = shown(kSome);
        QSignalSpy accepted(dialog.get(), &QDialog::accepted);
        auto* buttons = dialog->findChild<QDialogButtonBox*>();
        QTest::mouseClick(buttons->button(QDialogButtonBox::RestoreDefaults), Qt::LeftButton);
        const Preferences defaults{.theme = "system"};
        QVERIFY(dialog->preferences() == defaults);
        QVERIFY(dialog->isVisible());
        QTest::keyClick(dialog.get(), Qt::Key_Escape);
        QVERIFY(!dialog->isVisible());
        QCOMPARE(accepted.count(), 0);
    }

    void everyFieldHasALabelOrATextOfItsOwn() {
        const auto dialog = shown(kSome);
        for (const auto* label : dialog->findChildren<QLabel*>())
            QVERIFY2(label->buddy() != nullptr, qPrintable(label->text()));
        for (const auto* box : dialog->findChildren<QCheckBox*>())
            QVERIFY(!box->text().isEmpty());
    }
};

QTEST_MAIN(PreferencesDialogTest)
#include "preferences_dialog_test.moc"
