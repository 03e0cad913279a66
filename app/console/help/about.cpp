// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/about.h"

#include "app/console/help/library_versions.h"
#include "widgets/base/theme.h"
#include "widgets/plot/plot_style.h"
#include "widgets/view3d/vtk/vtk_version.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFont>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QScreen>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include <utility>
#include <vector>

namespace teleta::console {

namespace {

struct AboutText {
    Q_DECLARE_TR_FUNCTIONS(About)
};

QDialog* makeDialog(QWidget* parent, const QString& title, QWidget* content) {
    auto* dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(content, 1);
    layout->addWidget(buttons);
    return dialog;
}

} // namespace

base::ThemeChoice themeFromName(const QString& name) {
    if (name == QLatin1String("light"))
        return base::ThemeChoice::light;
    if (name == QLatin1String("dark"))
        return base::ThemeChoice::dark;
    return base::ThemeChoice::system;
}

void openAbout(QWidget* parent) {
    struct Library {
        const char* name;
        QString version;
        const char* licence;
    };
    const auto built = [](const char* version) { return QString::fromLatin1(version); };
    const std::vector<Library> libraries{
        {"Qt", built(qVersion()), "LGPL-3.0"},
        {"VTK", view3d::vtkLibraryVersion(), "BSD-3-Clause"},
        {"QCustomPlot", plot::libraryVersion(), "GPL-3.0"},
        {"Eigen", view3d::eigenLibraryVersion(), "MPL-2.0"},
        {"OpenCV", built(kOpenCvVersion), "Apache-2.0"},
        {"Boost", built(kBoostVersion), "BSL-1.0"},
        {"hidapi", built(kHidapiVersion), "GPL-3.0"},
        {"libmodbus", built(kLibmodbusVersion), "LGPL-2.1"},
        {"librsvg", built(kLibrsvgVersion), "LGPL-2.1"},
        {"cairo", built(kCairoVersion), "LGPL-2.1"},
        {"libzip", built(kLibzipVersion), "BSD-3-Clause"},
        {"JSON for Modern C++", built(kJsonVersion), "MIT"},
        {"toml++", built(kTomlVersion), "MIT"},
    };
    QString text =
        QStringLiteral("<h2>%1 %2</h2><p>%3</p><p>%4</p><table cellspacing='4' cellpadding='2'>")
            .arg(AboutText::tr("TeleTA Console"), QCoreApplication::applicationVersion(),
                 AboutText::tr("Shows, and lets the operator feel, what a remote robot arm touches."),
                 AboutText::tr("Free software under the GNU General Public License, version 3 or later. "
                               "It comes without any warranty."));
    for (const auto& [name, version, licence] : libraries)
        text += QStringLiteral("<tr><td>%1</td><td>%2</td><td>%3</td></tr>")
                    .arg(QLatin1String(name), version, QLatin1String(licence));
    text += QStringLiteral("</table>");
    auto* label = new QLabel(text);
    label->setObjectName(QStringLiteral("aboutText"));
    label->setTextInteractionFlags(Qt::TextBrowserInteraction);
    label->setWordWrap(true);
    auto* content = new QWidget;
    auto* picture = new QLabel(content);
    picture->setObjectName(QStringLiteral("icon"));
    picture->setPixmap(QApplication::windowIcon().pixmap(base::em(content, 5.0)));
    auto* row = new QHBoxLayout(content);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(base::grid(content, base::kSection));
    row->addWidget(picture, 0, Qt::AlignTop);
    row->addWidget(label, 1);
    makeDialog(parent, AboutText::tr("About TeleTA Console"), content)->open();
}

void openShortcuts(QWidget* parent) {
    // A row without an effect is the heading of those after it.
    const std::vector<std::pair<QString, QString>> shortcuts{
        {AboutText::tr("Everywhere"), QString()},
        {AboutText::tr("Esc Esc, Ctrl+."), AboutText::tr("STOP: everything that moves stops at once")},
        {AboutText::tr("Ctrl+1 to 6"), AboutText::tr("Page Operate, Patterns, Study, Calibrate, Cost, Plot")},
        {AboutText::tr("Ctrl+Z, Ctrl+Y"),
         AboutText::tr("Undo, redo: marks on the page Operate, edits on the pages Patterns and Calibrate")},
        {AboutText::tr("Ctrl+,"), AboutText::tr("Preferences")},
        {AboutText::tr("F11"), AboutText::tr("Full screen")},
        {AboutText::tr("F1"), AboutText::tr("Handbook: the page on what is shown")},
        {AboutText::tr("Shift+F1"), AboutText::tr("What's This")},
        {AboutText::tr("On the page Operate"), QString()},
        {AboutText::tr("Ctrl+R, M"), AboutText::tr("Record, mark this moment in the recording")},
        {AboutText::tr("F5, Shift+F5, Ctrl+F5"),
         AboutText::tr("Run the program of the arm, hold it, restart it")},
        {AboutText::tr("Shift with Q W E R, A S D F"), AboutText::tr("Move the arm, in Jog")},
        {AboutText::tr("Ctrl+Shift+M"),
         AboutText::tr("Show one view alone, or all again; a double click on its title does the same")},
        {AboutText::tr("Ctrl+W"), AboutText::tr("Close the source that is shown")},
        {AboutText::tr("Ctrl+Shift+N"), AboutText::tr("Forget the explored contour")},
        {AboutText::tr("Ctrl+Alt+C"), AboutText::tr("Release control of the site")},
        {AboutText::tr("Arrow keys"), AboutText::tr("Move the read-out from taxel to taxel, in the heatmap")},
        {AboutText::tr("1, 2, 3, 4"),
         AboutText::tr("Front, top, side, isometric view, in the reconstruction")},
        {AboutText::tr("In the playback bar"), QString()},
        {AboutText::tr("Space"), AboutText::tr("Play or pause")},
        {AboutText::tr("Left, Right"), AboutText::tr("One frame back or forward")},
        {AboutText::tr("Home, End"), AboutText::tr("Start or end of the recording")},
        {AboutText::tr("In pictures and charts"), QString()},
        {AboutText::tr("Ctrl+wheel"), AboutText::tr("Zoom the picture or the time under the mouse")},
        {AboutText::tr("Shift+wheel"), AboutText::tr("Scroll through time")},
        {AboutText::tr("On the page Patterns"), QString()},
        {AboutText::tr("Ctrl+N, O, S, Shift+S, E"), AboutText::tr("New, open, save, save as, export")},
        {AboutText::tr("Ctrl+[, Ctrl+], Ctrl+M, Ctrl+L"),
         AboutText::tr("Rotate around the ring, mirror, other arm")},
        {AboutText::tr("Ctrl+Alt+1 to 5"),
         AboutText::tr("Add a sweep, ring, phantom, ramp, pulse train at the playhead")},
        {AboutText::tr("F2, Ctrl+D, Delete, Ctrl+Z"),
         AboutText::tr("Rename, duplicate, delete, undo, in the library")},
        {AboutText::tr("In the timeline of a pattern"), QString()},
        {AboutText::tr("Space, P"), AboutText::tr("Play or pause; pen")},
        {AboutText::tr("Ctrl+X, C, V, Shift+V, D"),
         AboutText::tr("Cut, copy, paste in place, paste at the playhead, duplicate")},
        {AboutText::tr(",  .  with Shift"),
         AboutText::tr("Previous or next breakpoint; with Shift, add it to the selection")},
        {AboutText::tr("N, Shift+N"), AboutText::tr("Next or previous object")},
        {AboutText::tr("Enter, Insert, Delete"),
         AboutText::tr("Type numbers, add a breakpoint at the playhead, delete")},
        {AboutText::tr("Arrow keys, with Shift"),
         AboutText::tr("Move the selection; without one, the playhead and the lane")},
        {AboutText::tr("[  ]  \\"), AboutText::tr("Loop start, loop end, no loop")},
        {AboutText::tr("Ctrl++, Ctrl+-, Ctrl+0"), AboutText::tr("Zoom in, out, to fit")},
    };
    auto* table = new QTableWidget(static_cast<int>(shortcuts.size()), 2);
    table->setHorizontalHeaderLabels({AboutText::tr("Keys"), AboutText::tr("Effect")});
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setShowGrid(false);
    for (int row = 0; row < table->rowCount(); ++row) {
        const auto& [keys, effect] = shortcuts[static_cast<std::size_t>(row)];
        auto* first = new QTableWidgetItem(keys);
        table->setItem(row, 0, first);
        if (effect.isEmpty()) {
            QFont bold = table->font();
            bold.setBold(true);
            first->setFont(bold);
            first->setFlags(Qt::ItemIsEnabled);
            table->setSpan(row, 0, 1, 2);
        } else {
            table->setItem(row, 1, new QTableWidgetItem(effect));
        }
    }
    table->resizeColumnsToContents();
    const int columns = table->horizontalHeader()->length();
    const int rows = table->verticalHeader()->length();
    // Wraps lines on narrow screens.
    table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    QDialog* dialog = makeDialog(parent, AboutText::tr("Shortcuts"), table);
    // Shows the whole text if the screen is large enough.
    const int frame = 2 * table->frameWidth();
    const QSize content(columns + frame + table->verticalScrollBar()->sizeHint().width(),
                        rows + table->horizontalHeader()->sizeHint().height() + frame);
    const QSize beside = dialog->sizeHint() - table->sizeHint();
    dialog->resize((content + beside).boundedTo(parent->screen()->availableSize() * 9 / 10));
    dialog->open();
}

} // namespace teleta::console
