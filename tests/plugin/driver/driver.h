// SPDX-License-Identifier: GPL-3.0-or-later
// What the scenarios share: CloudCompare's window, driven from within as a user would. A scenario is a file of its own
// (scenario_<what>.cpp) that registers one function under the name that S2B_DRIVER_SCENARIO gives.
#pragma once

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QRadioButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>
#include <QTreeWidget>
#include <QtTest/QTest>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include <ccColorScale.h>
#include <ccGLMatrix.h>
#include <ccMainAppInterface.h>
#include <ccMesh.h>
#include <ccPointCloud.h>
#include <ccScalarField.h>

#include "processor_time.h"

/// How much longer everything may take: sanitizers are slow.
[[nodiscard]] inline int slowdown()
{
    return qEnvironmentVariableIsSet("LD_PRELOAD") ? 5 : 1;
}

class Driver : public QObject
{
public:
    explicit Driver(ccMainAppInterface& app) : m_app(app) {}

    [[nodiscard]] ccMainAppInterface& app() { return m_app; }

    /// One claim, said on standard output; a false one fails the test.
    void check(bool isOk, const QString& claim);
    [[nodiscard]] int failures() const { return m_failures; }

    /// The path of an artefact that is kept.
    [[nodiscard]] QString output(const QString& file) const;
    /// The whole screen, as an artefact.
    void shoot(const QString& name);
    /// One window or list, as an artefact.
    void shoot(QWidget* widget, const QString& name);

    /// Scrolls the Properties to what the plugin says of the selected entity.
    void showMetaData();

    [[nodiscard]] QMenu* pluginsMenu();  ///< Plugins
    [[nodiscard]] QMenu* menu();         ///< Plugins > Scan to BIM
    [[nodiscard]] QAction* action(const QString& name);

    /// The first cloud that is a scan; null while there is none.
    [[nodiscard]] ccPointCloud* cloud();
    /// The newest model group; null while there is none.
    [[nodiscard]] ccHObject* model();
    [[nodiscard]] std::size_t entityCount();

    template <typename Entity = ccHObject>
    [[nodiscard]] std::vector<Entity*> named(const QString& start)
    {
        std::vector<Entity*> found;
        ccHObject::Container all;
        m_app.dbRootObject()->filterChildren(all, true);
        for (ccHObject* entity : all)
        {
            if (entity->getName().startsWith(start) && dynamic_cast<Entity*>(entity))
                found.push_back(static_cast<Entity*>(entity));
        }
        return found;
    }

    /// The labels in the tree.
    [[nodiscard]] std::vector<ccHObject*> labels();
    /// Whether a place is in the middle of the view. The pivot would not tell: CloudCompare sets it to what is drawn
    /// there.
    [[nodiscard]] bool isInTheMiddle(const CCVector3d& place);

    void unselectAll();
    void select(ccHObject* entity);
    /// Selects as a user does, with the mouse in the DB tree.
    void clickInTree(ccHObject* entity);
    /// Adds to the selection, with the control key held as it were.
    void selectToo(ccHObject* entity);
    /// The model and the cloud.
    void selectBoth();

    /// Runs `inside` as soon as a modal widget with that name, or of that class, is there, as a user would.
    void whenShown(const QString& name, const std::function<void(QWidget*)>& inside, int tries = 600);
    void press(QWidget* dialog, QDialogButtonBox::StandardButton button);

    /// With the dialog's defaults and without a file; `prepare` may change the dialog first.
    void reconstructQuietly(const std::function<void(QWidget*)>& prepare = {});
    /// Selects the model and exports it; false when no file was written.
    bool exportModel(const QString& file);
    /// Closes the message that is to come and gives what it said, once it did.
    void expectMessage(QString& said);

    /// The tool Edit > Apply transformation of CloudCompare itself, on one entity.
    void applyTransformation(ccHObject* entity, const ccGLMatrix& matrix);
    /// Picks a point as a click in the 3D view would.
    void pick(ccHObject* entity, const CCVector3& point);

    /// Presses the button of the progress that is shown, and has the time until the end of the run measured.
    void cancel(QWidget* progress, ProcessorTime& sinceCancel);
    /// Whether the promise was kept: half a second from the click to the end.
    void checkCancelled(const ProcessorTime& sinceCancel, const QString& when);

    /// A window or a dock that is not modal; null where there is none.
    [[nodiscard]] QWidget* shown(const QString& name);
    /// Waits for something to become true while the window goes on.
    bool waitFor(const std::function<bool()>& condition, int timeout_ms = 60000);

private:
    ccMainAppInterface& m_app;
    int m_failures = 0;
};

/// Registers a scenario for as long as the program runs.
class Scenario
{
public:
    using Function = void (*)(Driver&);
    Scenario(const char* name, Function function);
    /// Null when there is none of that name.
    [[nodiscard]] static Function find(const QString& name);
};
