// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_log.h"

#include <QLoggingCategory>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace teleta::view3d {

namespace {

Q_LOGGING_CATEGORY(view3dLog, "teleta.view3d")

class QtLogWindow : public vtkOutputWindow {
public:
    static QtLogWindow* New();

    void DisplayText(const char* text) override { qCInfo(view3dLog, "%s", text); }
    void DisplayErrorText(const char* text) override { qCWarning(view3dLog, "%s", text); }
    void DisplayWarningText(const char* text) override { qCWarning(view3dLog, "%s", text); }
    void DisplayGenericWarningText(const char* text) override { qCWarning(view3dLog, "%s", text); }
    void DisplayDebugText(const char* text) override { qCDebug(view3dLog, "%s", text); }

protected:
    QtLogWindow() = default;
};

vtkStandardNewMacro(QtLogWindow);

} // namespace

void routeVtkMessagesToQtLog() {
    static bool routed = false;
    if (!routed) {
        const vtkNew<QtLogWindow> window;
        vtkOutputWindow::SetInstance(window);
        routed = true;
    }
}

} // namespace teleta::view3d
