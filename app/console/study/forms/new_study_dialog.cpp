// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/new_study_dialog.h"

#include "app/console/study/forms/server_fields.h"
#include "backend/study/protocol/stimulus_set.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSpinBox>
#include <QVBoxLayout>

#include <utility>

namespace teleta::console {

namespace {

constexpr std::size_t kPaperParticipants = 6;
constexpr int kMostParticipants = 1000;

/// A protocol that can be used for a study now.
core::Expected<study::Protocol> usableProtocol(const std::string& path) {
    core::Expected<study::Protocol> protocol = study::readProtocol(path);
    if (protocol) {
        TELETA_CHECK(study::readOwnStimuli(*protocol));
    }
    return protocol;
}

} // namespace

NewStudyDialog::NewStudyDialog(study::Protocol protocol, const QString& folder, QWidget* parent,
                               const QString& from)
    : QDialog(parent)
    , m_protocol(base::named<QComboBox>("protocol", this))
    , m_trials(base::named<QLabel>("trials", this))
    , m_folder(base::named<QLineEdit>("folder", folder, this))
    , m_store(base::named<QComboBox>("store", this))
    , m_server(new ServerFields(this))
    , m_mode(base::named<QComboBox>("mode", this))
    , m_seed(base::named<QLineEdit>("seed", QString::number(QRandomGenerator::system()->generate()), this))
    , m_participants(new QSpinBox(this))
    , m_participantsLabel(new QLabel(tr("&Participants"), this))
    , m_problem(base::named<QLabel>("problem", this)) {
    setWindowTitle(tr("New study"));
    setObjectName(QStringLiteral("newStudy"));
    m_protocol->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_store->addItem(tr("In a file in this folder, for one station"));
    m_store->addItem(tr("On a PostgreSQL server, shared by several stations"));
    m_mode->addItem(tr("Run: real participants, data count"), static_cast<int>(study::Mode::run));
    m_mode->addItem(tr("Pilot: people try it, marked PILOT everywhere"),
                    static_cast<int>(study::Mode::pilot));
    m_mode->addItem(tr("Simulated: no people, marked SIMULATED everywhere"),
                    static_cast<int>(study::Mode::simulated));
    m_participants->setRange(1, kMostParticipants);
    m_participants->setValue(static_cast<int>(kPaperParticipants));
    m_participantsLabel->setBuddy(m_participants);
    m_seed->setToolTip(tr("Determines the order of all trials: the same seed gives the same study. "
                          "It is drawn at random, shown here and kept with the study."));
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);
    m_problem->setMinimumWidth(base::em(this, 32));

    auto* fromFile = base::named<QPushButton>("fromFile", tr("F&rom a file\u2026"), this);
    fromFile->setToolTip(tr("A protocol of your own (TOML)"));
    auto* choice = new QHBoxLayout;
    choice->addWidget(m_protocol, 1);
    choice->addWidget(fromFile);
    auto* browse = new QPushButton(tr("C&hoose\u2026"), this);
    auto* place = new QHBoxLayout;
    place->addWidget(m_folder, 1);
    place->addWidget(browse);
    auto* form = new QFormLayout;
    base::addFormRow(*form, tr("Pr&otocol"), choice, m_protocol);
    form->addRow(QString(), m_trials);
    base::addFormRow(*form, tr("New &folder"), place, m_folder);
    form->addRow(tr("S&torage"), m_store);
    form->addRow(QString(), m_server);
    form->addRow(tr("&Mode"), m_mode);
    form->addRow(tr("&Seed"), m_seed);
    form->addRow(m_participantsLabel, m_participants);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_make = buttons->addButton(tr("Create the study"), QDialogButtonBox::AcceptRole);
    m_make->setObjectName(QStringLiteral("makeStudy"));
    m_make->setDefault(true);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_problem);
    layout->addWidget(buttons);

    connect(fromFile, &QPushButton::clicked, this, &NewStudyDialog::askForProtocol);
    connect(m_protocol, &QComboBox::activated, this, [this] {
        m_refused.clear();
        check();
    });
    connect(browse, &QPushButton::clicked, this, &NewStudyDialog::chooseFolder);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_folder, &QLineEdit::textChanged, this, &NewStudyDialog::check);
    connect(m_seed, &QLineEdit::textChanged, this, &NewStudyDialog::check);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &NewStudyDialog::check);
    connect(m_store, &QComboBox::currentIndexChanged, this, &NewStudyDialog::check);
    connect(m_server, &ServerFields::changed, this, &NewStudyDialog::check);
    offer(std::move(protocol), from);
}

void NewStudyDialog::offer(study::Protocol protocol, const QString& from) {
    const QString name = QString::fromStdString(protocol.name);
    m_protocols.push_back(std::move(protocol));
    m_protocol->addItem(from.isEmpty() ? name
                                       : tr("%1 (%2)", "a protocol; where it is from").arg(name, from));
    check();
}

void NewStudyDialog::read(const QString& path) {
    base::runInBackground(
        this, [path] { return usableProtocol(path.toStdString()); },
        [this, path](const core::Expected<study::Protocol>& protocol) {
            m_refused = protocol ? QString() : QString::fromStdString(core::describe(protocol.error()));
            if (protocol) {
                // A changed protocol that is read again replaces the earlier one.
                if (const int old = m_protocol->findData(path); old >= 0) {
                    m_protocols.erase(m_protocols.begin() + old);
                    m_protocol->removeItem(old);
                }
                offer(*protocol, QFileInfo(path).fileName());
                const int newest = m_protocol->count() - 1;
                m_protocol->setItemData(newest, path);
                m_protocol->setCurrentIndex(newest);
            }
            check();
        });
}

const study::Protocol& NewStudyDialog::protocol() const {
    return m_protocols[static_cast<std::size_t>(m_protocol->currentIndex())];
}

void NewStudyDialog::setMode(study::Mode mode) {
    m_mode->setCurrentIndex(m_mode->findData(static_cast<int>(mode)));
}

QString NewStudyDialog::folder() const {
    return QDir::cleanPath(m_folder->text().trimmed());
}

study::StoreLocation NewStudyDialog::location() const {
    return {folder().toStdString(), m_store->currentIndex() == 1 ? m_server->url() : std::string()};
}

study::StudyHead NewStudyDialog::head() const {
    study::StudyHead head;
    head.protocol = protocol();
    head.seed = m_seed->text().trimmed().toULongLong();
    head.mode = static_cast<study::Mode>(m_mode->currentData().toInt());
    if (head.mode == study::Mode::simulated)
        head.plannedParticipants = static_cast<std::size_t>(m_participants->value());
    head.created = QDateTime::currentDateTimeUtc();
    head.appVersion = QCoreApplication::applicationVersion().toStdString();
    return head;
}

void NewStudyDialog::askForProtocol() {
    base::askToOpen(this, {.title = tr("Open a protocol"), .filters = {tr("Protocols (*.toml)")}},
                    [this](const QString& path) { read(path); });
}

void NewStudyDialog::chooseFolder() {
    base::askForFolder(this, {.title = tr("Study folder"), .folder = m_folder->text()},
                       [this](const QString& path) { m_folder->setText(path); });
}

void NewStudyDialog::check() {
    bool isNumber = false;
    (void)m_seed->text().trimmed().toULongLong(&isNumber);
    const std::vector<std::string> missing = study::missingStimuli(protocol());
    m_trials->setText(
        tr("%n test trial(s) per participant", nullptr, static_cast<int>(protocol().testTrials())));
    QString problem;
    if (!missing.empty())
        problem = tr("There is no tactile pattern for %1: name a file for it in the protocol.")
                      .arg(QString::fromStdString(missing.front()));
    else if (m_folder->text().trimmed().isEmpty() || !QDir::isAbsolutePath(folder()))
        problem = tr("Choose a folder by its full path.");
    else if (!isNumber)
        problem = tr("The seed is a whole number from 0 to 18446744073709551615.");
    else if (m_store->currentIndex() == 1)
        problem = m_server->problem();
    m_server->setVisible(m_store->currentIndex() == 1);
    QStringList said{problem};
    if (!m_refused.isEmpty())
        said.prepend(
            tr("The file is not a usable protocol; the one above stays selected. %1").arg(m_refused));
    said.removeAll(QString());
    m_problem->setText(said.join(QLatin1Char('\n')));
    m_make->setEnabled(problem.isEmpty());
    const bool simulated = m_mode->currentData().toInt() == static_cast<int>(study::Mode::simulated);
    m_participants->setVisible(simulated);
    m_participantsLabel->setVisible(simulated);
}

} // namespace teleta::console
