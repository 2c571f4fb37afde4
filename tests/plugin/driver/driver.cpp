// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

#include <QPlainTextEdit>
#include <QScreen>
#include <QTreeView>

#include <map>

#include <ccGLWindowInterface.h>
#include <ccPickingHub.h>

namespace
{

std::map<QString, Scenario::Function>& scenarios()
{
    static std::map<QString, Scenario::Function> all;
    return all;
}

QMenu* subMenu(const QList<QAction*>& actions, const QString& title)
{
    for (QAction* action : actions)
    {
        if (action->menu() && action->text().remove('&') == title)
            return action->menu();
    }
    return nullptr;
}

/// Labels are shown there with more than their names: an entity is found by itself.
QModelIndex findIn(const QAbstractItemModel& tree, const QModelIndex& parent, const ccHObject* entity)
{
    for (int row = 0; row < tree.rowCount(parent); ++row)
    {
        const QModelIndex index = tree.index(row, 0, parent);
        const QModelIndex found = index.internalPointer() == entity ? index : findIn(tree, index, entity);
        if (found.isValid())
            return found;
    }
    return {};
}

}  // namespace

Scenario::Scenario(const char* name, Function function)
{
    scenarios()[name] = function;
}

Scenario::Function Scenario::find(const QString& name)
{
    const auto found = scenarios().find(name);
    return found == scenarios().end() ? nullptr : found->second;
}

void Driver::check(bool isOk, const QString& claim)
{
    std::printf("%s %s\n", isOk ? "ok  " : "FAIL", qPrintable(claim));
    std::fflush(stdout);
    m_failures += isOk ? 0 : 1;
}

QString Driver::output(const QString& file) const
{
    return qEnvironmentVariable("S2B_DRIVER_OUTPUT") + "/" + file;
}

void Driver::shoot(const QString& name)
{
    QTest::qWait(300);
    m_app.getMainWindow()->screen()->grabWindow(0).save(output(name + ".png"));
}

void Driver::shoot(QWidget* widget, const QString& name)
{
    QTest::qWait(300);
    widget->grab().save(output(name + ".png"));
}

void Driver::showMetaData()
{
    QApplication::processEvents();
    auto* view = m_app.getMainWindow()->findChild<QTreeView*>("propertiesTreeView");
    for (int row = 0; view && view->model() && row < view->model()->rowCount(); ++row)
    {
        if (view->model()->index(row, 0).data(Qt::AccessibleDescriptionRole).toString() == "Meta data")
            view->scrollTo(view->model()->index(row, 0), QAbstractItemView::PositionAtTop);
    }
}

QMenu* Driver::pluginsMenu()
{
    return subMenu(m_app.getMainWindow()->menuBar()->actions(), "Plugins");
}

QMenu* Driver::menu()
{
    QMenu* plugins = pluginsMenu();
    return plugins ? subMenu(plugins->actions(), "Scan to BIM") : nullptr;
}

QAction* Driver::action(const QString& name)
{
    if (auto* found = m_app.getMainWindow()->findChild<QAction*>(name))
        return found;
    for (QAction* action : menu()->actions())
    {
        if (action->objectName() == name)
            return action;
    }
    return nullptr;
}

ccPointCloud* Driver::cloud()
{
    ccHObject::Container clouds;
    m_app.dbRootObject()->filterChildren(clouds, true, CC_TYPES::POINT_CLOUD, true);
    for (ccHObject* entity : clouds)
    {
        if (entity->getName() != "vertices")
            return static_cast<ccPointCloud*>(entity);
    }
    return nullptr;
}

ccHObject* Driver::model()
{
    ccHObject* newest = nullptr;
    for (ccHObject* entity : named(QString()))
    {
        if (entity->hasMetaData("S2B.Building") && (!newest || entity->getUniqueID() > newest->getUniqueID()))
            newest = entity;
    }
    return newest;
}

std::size_t Driver::entityCount()
{
    ccHObject::Container all;
    m_app.dbRootObject()->filterChildren(all, true);
    return all.size();
}

std::vector<ccHObject*> Driver::labels()
{
    ccHObject::Container found;
    m_app.dbRootObject()->filterChildren(found, true, CC_TYPES::LABEL_2D, true);
    return {found.begin(), found.end()};
}

bool Driver::isInTheMiddle(const CCVector3d& place)
{
    constexpr double kNear_px = 3;
    ccGLCameraParameters camera;
    m_app.getActiveGLWindow()->getGLCameraParameters(camera);
    CCVector3d seen;
    camera.project(place, seen);
    return std::hypot(seen.x - camera.viewport[2] / 2.0, seen.y - camera.viewport[3] / 2.0) < kNear_px;
}

void Driver::unselectAll()
{
    const ccHObject::Container selection = m_app.getSelectedEntities();
    for (ccHObject* entity : selection)
        m_app.setSelectedInDB(entity, false);
    QApplication::processEvents();
}

void Driver::select(ccHObject* entity)
{
    unselectAll();
    m_app.setSelectedInDB(entity, true);
    QApplication::processEvents();
}

void Driver::clickInTree(ccHObject* entity)
{
    auto* view = m_app.getMainWindow()->findChild<QTreeView*>("dbTreeView");
    const QModelIndex index = findIn(*view->model(), {}, entity);
    if (!index.isValid())
        return check(false, entity->getName() + " is in the tree");
    view->scrollTo(index);
    QTest::mouseClick(view->viewport(), Qt::LeftButton, Qt::NoModifier, view->visualRect(index).center());
    QApplication::processEvents();
}

void Driver::selectToo(ccHObject* entity)
{
    for (auto* view : m_app.getMainWindow()->findChildren<QTreeView*>())
    {
        if (!view->model() || view->model()->rowCount() == 0)
            continue;
        const QModelIndex top = view->model()->index(0, 0);
        for (const QModelIndex& index :
             view->model()->match(top, Qt::DisplayRole, entity->getName(), 1, Qt::MatchExactly | Qt::MatchRecursive))
            view->selectionModel()->select(index, QItemSelectionModel::Select);
    }
    QApplication::processEvents();
}

void Driver::selectBoth()
{
    select(model());
    selectToo(cloud());
}

void Driver::whenShown(const QString& name, const std::function<void(QWidget*)>& inside, int tries)
{
    QTimer::singleShot(100 * slowdown(), this,
                       [=, this]
                       {
                           QWidget* widget = QApplication::activeModalWidget();
                           if (widget && (widget->objectName() == name || widget->inherits(qPrintable(name))))
                               inside(widget);
                           else if (tries > 0)
                               whenShown(name, inside, tries - 1);
                           else
                               check(false, name + " was shown");
                       });
}

void Driver::press(QWidget* dialog, QDialogButtonBox::StandardButton button)
{
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(button), Qt::LeftButton);
}

void Driver::reconstructQuietly(const std::function<void(QWidget*)>& prepare)
{
    select(cloud());
    whenShown("S2BReconstructDlg",
              [this, prepare](QWidget* dialog)
              {
                  dialog->findChild<QCheckBox*>("writeIfc")->setChecked(false);
                  if (prepare)
                      prepare(dialog);
                  press(dialog, QDialogButtonBox::Ok);
              });
    action("S2B.Reconstruct")->trigger();
}

bool Driver::exportModel(const QString& file)
{
    QFile::remove(output(file));
    select(model());
    whenShown("S2BExportDialog",
              [this, file](QWidget* dialog)
              {
                  auto* files = static_cast<QFileDialog*>(dialog);
                  files->findChild<QLineEdit*>("fileNameEdit")->setText(output(file));
                  QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
              });
    action("S2B.ExportIfc")->trigger();
    QTest::qWait(200);
    return QFile::exists(output(file));
}

void Driver::expectMessage(QString& said)
{
    whenShown("S2BMessage",
              [&said](QWidget* box)
              {
                  said = static_cast<QMessageBox*>(box)->text();
                  QTest::mouseClick(static_cast<QMessageBox*>(box)->button(QMessageBox::Ok), Qt::LeftButton);
              });
}

void Driver::applyTransformation(ccHObject* entity, const ccGLMatrix& matrix)
{
    select(entity);
    whenShown("ccApplyTransformationDlg",
              [this, matrix](QWidget* dialog)
              {
                  dialog->findChild<QPlainTextEdit*>("matrixTextEdit")->setPlainText(matrix.toString(12));
                  press(dialog, QDialogButtonBox::Ok);
              });
    m_app.getMainWindow()->findChild<QAction*>("actionApplyTransformation")->trigger();
    QTest::qWait(100);
}

void Driver::pick(ccHObject* entity, const CCVector3& point)
{
    m_app.pickingHub()->processPickedItem(entity, 0, 0, 0, point, {});
    QTest::qWait(100);
}

void Driver::cancel(QWidget* progress, ProcessorTime& sinceCancel)
{
    sinceCancel.start();
    QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
}

void Driver::checkCancelled(const ProcessorTime& sinceCancel, const QString& when)
{
    constexpr qint64 kPromise_ms = 500;
    constexpr qint64 kWaited_ms = 20000;  // on a busy machine
    if (!sinceCancel.isRunning())
        return check(false, "cancelled " + when);
    const qint64 busy_ms = sinceCancel.busiest_ms();
    const qint64 passed_ms = sinceCancel.elapsed_ms();
    check(busy_ms < slowdown() * kPromise_ms && passed_ms < slowdown() * kWaited_ms,
          QString("cancelled %1: ended after %2 ms of work, %3 ms later").arg(when).arg(busy_ms).arg(passed_ms));
}

QWidget* Driver::shown(const QString& name)
{
    for (QWidget* widget : QApplication::allWidgets())
    {
        if (widget->objectName() == name && widget->isVisible())
            return widget;
    }
    return nullptr;
}

bool Driver::waitFor(const std::function<bool()>& condition, int timeout_ms)
{
    return QTest::qWaitFor(condition, slowdown() * timeout_ms);
}
