// SPDX-License-Identifier: GPL-3.0-or-later
// A plugin of the tests alone: drives CloudCompare's window from within and ends it with the number of failed checks.
//
//   CloudCompare ":start-plugin:S2B_window_driver" scan.bin
//
// S2B_DRIVER_SCENARIO says what to do, S2B_DRIVER_OUTPUT where the screenshots go.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QScreen>
#include <QTabWidget>
#include <QTimer>
#include <QTreeView>
#include <QTreeWidget>
#include <QtTest/QTest>

#include <cmath>
#include <cstdio>

#include <ccColorScale.h>
#include <ccMesh.h>
#include <ccPointCloud.h>
#include <ccScalarField.h>
#include <ccStdPluginInterface.h>

namespace
{

constexpr int kStart_ms = 1500;       // CloudCompare has shown its window by then, and mostly opened the file
constexpr int kOpenTries = 40;        // a large file on a busy machine
constexpr int kWatchdog_ms = 240000;  // far above any scenario: a hang has to end the test
constexpr int kCancel_ms = 500;       // the promise to the user

}  // namespace

class WindowDriver : public QObject, public ccStdPluginInterface
{
    Q_OBJECT
    Q_INTERFACES(ccPluginInterface ccStdPluginInterface)
    Q_PLUGIN_METADATA(IID "cccorp.cloudcompare.plugin.S2BWindowDriver" FILE "window_driver.json")

public:
    QString getName() const override { return "S2B window driver"; }
    QList<QAction*> getActions() override { return {new QAction("S2B window driver", this)}; }
    bool start() override
    {
        QTimer::singleShot(kStart_ms, this, &WindowDriver::run);
        QTimer::singleShot(kWatchdog_ms, this,
                           [this]
                           {
                               check(false, "the scenario ended in time");
                               finish();
                           });
        return true;
    }

private:
    void check(bool isOk, const QString& claim)
    {
        std::printf("%s %s\n", isOk ? "ok  " : "FAIL", qPrintable(claim));
        std::fflush(stdout);
        m_failures += isOk ? 0 : 1;
    }

    void finish() { QCoreApplication::exit(m_failures ? 1 : 0); }

    void shoot(const QString& name)
    {
        QTest::qWait(300);
        m_app->getMainWindow()->screen()->grabWindow(0).save(qEnvironmentVariable("S2B_DRIVER_OUTPUT") + "/" + name +
                                                             ".png");
    }

    QMenu* menu()
    {
        for (QAction* top : m_app->getMainWindow()->menuBar()->actions())
        {
            if (!top->menu() || top->text().remove('&') != "Plugins")
                continue;
            m_plugins = top->menu();
            for (QAction* sub : top->menu()->actions())
            {
                if (sub->menu() && sub->text() == "Scan to BIM")
                    return sub->menu();
            }
        }
        return nullptr;
    }

    QAction* action(const QString& name)
    {
        return m_app->getMainWindow()->findChild<QAction*>(name) ? m_app->getMainWindow()->findChild<QAction*>(name)
                                                                 : actionInMenu(name);
    }
    QAction* actionInMenu(const QString& name)
    {
        for (QAction* a : menu()->actions())
        {
            if (a->objectName() == name)
                return a;
        }
        return nullptr;
    }

    template <typename Entity = ccHObject>
    std::vector<Entity*> named(const QString& start)
    {
        std::vector<Entity*> found;
        ccHObject::Container all;
        m_app->dbRootObject()->filterChildren(all, true);
        for (ccHObject* entity : all)
        {
            if (entity->getName().startsWith(start) && dynamic_cast<Entity*>(entity))
                found.push_back(static_cast<Entity*>(entity));
        }
        return found;
    }

    ccPointCloud* cloud()
    {
        ccHObject::Container clouds;
        m_app->dbRootObject()->filterChildren(clouds, true, CC_TYPES::POINT_CLOUD, true);
        for (ccHObject* entity : clouds)
        {
            if (entity->getName() != "vertices")
                return static_cast<ccPointCloud*>(entity);
        }
        return nullptr;
    }

    void unselectAll()
    {
        const ccHObject::Container selection = m_app->getSelectedEntities();
        for (ccHObject* entity : selection)
            m_app->setSelectedInDB(entity, false);
        QApplication::processEvents();
    }

    void select(ccHObject* entity)
    {
        unselectAll();
        m_app->setSelectedInDB(entity, true);
        QApplication::processEvents();
    }

    // Runs `inside` as soon as a modal widget with that name is there, as a user would.
    void whenShown(const QString& name, const std::function<void(QWidget*)>& inside, int tries = 100)
    {
        QTimer::singleShot(100, this,
                           [=, this]
                           {
                               QWidget* widget = QApplication::activeModalWidget();
                               if (widget && widget->objectName() == name)
                                   inside(widget);
                               else if (tries > 0)
                                   whenShown(name, inside, tries - 1);
                               else
                                   check(false, name + " was shown");
                           });
    }

    static void press(QWidget* dialog, QDialogButtonBox::StandardButton button)
    {
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(button), Qt::LeftButton);
    }

    void run()
    {
        if (!cloud() &&
            ++m_waits < kOpenTries)  // still loading: events are handled meanwhile, but the window does not run yet
        {
            QTimer::singleShot(kStart_ms, this, &WindowDriver::run);
            return;
        }
        m_app->getMainWindow()->resize(1400, 900);
        m_app->getMainWindow()->move(0, 0);
        const QString scenario = qEnvironmentVariable("S2B_DRIVER_SCENARIO");
        check(cloud() != nullptr, "the cloud is open");
        check(menu() != nullptr, "Plugins > Scan to BIM is there");
        if (!m_failures)
        {
            if (scenario == "reconstruct")
                reconstruct();
            else if (scenario == "cancel")
                cancel();
            else if (scenario == "labels")
                labels();
            else if (scenario == "reopened")
                reopened();
            else if (scenario == "validate")
                validate();
            else
                check(false, "the scenario is known");
        }
        finish();
    }

    void reconstruct()
    {
        QAction* reconstruct = action("S2B.Reconstruct");
        QAction* exportIfc = action("S2B.ExportIfc");
        check(reconstruct && exportIfc, "both actions are there");
        unselectAll();
        check(!reconstruct->isEnabled() && !exportIfc->isEnabled(), "nothing is enabled without a selection");
        select(cloud());
        check(reconstruct->isEnabled() && !exportIfc->isEnabled(), "a cloud can be reconstructed, and not be exported");
        showMenu();

        const CCVector3 firstPoint = *cloud()->getPoint(0);
        const unsigned fields = cloud()->getNumberOfScalarFields();
        bool wasResponsive = false;
        whenShown("S2BReconstructDlg",
                  [&](QWidget* dialog)
                  {
                      auto* field = dialog->findChild<QComboBox*>("labelField");
                      check(field && field->currentText() == "Classification", "the label field is proposed");
                      check(dialog->findChild<QTreeWidget*>("classes")->topLevelItemCount() > 3,
                            "the classes are listed");
                      auto* thickness = dialog->findChild<QDoubleSpinBox*>("walls.defaultThickness");
                      thickness->setValue(0.18);
                      shoot("dialog");
                      dialog->findChild<QTabWidget*>("tabs")->setCurrentIndex(1);
                      bool isShown = false;
                      for (auto* box : dialog->findChildren<QDoubleSpinBox*>("walls.defaultThickness"))
                          isShown = isShown || (box != thickness && box->value() == 0.18);
                      check(isShown, "the expert page shows what was set in front");
                      shoot("dialog_parameters");
                      dialog->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
                      dialog->findChild<QCheckBox*>("writeIfc")->setChecked(true);
                      dialog->findChild<QLineEdit*>("ifcPath")->setText(qEnvironmentVariable("S2B_DRIVER_OUTPUT") +
                                                                        "/dialog.ifc");
                      whenShown("S2BProgress",
                                [&](QWidget* progress)
                                {
                                    wasResponsive = progress->isVisible();
                                    shoot("progress");
                                });
                      press(dialog, QDialogButtonBox::Ok);
                  });
        reconstruct->trigger();
        QTest::qWait(500);
        check(wasResponsive, "progress was shown while it ran");
        check(QFile::exists(qEnvironmentVariable("S2B_DRIVER_OUTPUT") + "/dialog.ifc"), "the IFC file was written");
        checkTree();
        check((*cloud()->getPoint(0) - firstPoint).norm2() == 0 && cloud()->getNumberOfScalarFields() == fields,
              "the cloud is unchanged");
        showResult();
        exportWithoutOneWall(exportIfc);
    }

    void showMenu()
    {
        m_plugins->popup(m_app->getMainWindow()->menuBar()->mapToGlobal(QPoint(300, 24)));
        for (QAction* sub : m_plugins->actions())
        {
            if (sub->text() == "Scan to BIM")
                m_plugins->setActiveAction(sub);
        }
        shoot("menu");
        menu()->close();
        m_plugins->close();
        QApplication::processEvents();
    }

    void checkTree()
    {
        const auto walls = named<ccMesh>("Wall ");
        check(named("Level 0").size() == 1, "there is a storey");
        check(!walls.empty(), QString("there are walls: %1").arg(walls.size()));
        check(!named<ccMesh>("Door ").empty(), "there are doors");
        for (const ccMesh* wall : walls)
        {
            if (wall->getParent()->getName() != "Walls" || wall->getParent()->getParent()->getName() != "Level 0")
                return check(false, "walls are below storey > Walls");
        }
        check(!walls.empty() && walls.front()->hasMetaData("Thickness") && walls.front()->hasMetaData("Length"),
              "a wall's dimensions are meta data");
        check(!walls.empty() && walls.front()->getAssociatedCloud()->getGlobalShift().x == cloud()->getGlobalShift().x,
              "the model lies over the cloud");
    }

    void showResult()
    {
        unselectAll();
        m_app->setView(CC_ISO_VIEW_1);
        m_app->setGlobalZoom();
        m_app->redrawAll();
        shoot("model_over_points");
        cloud()->setEnabled(false);
        const auto walls = named<ccMesh>("Wall ");
        if (!walls.empty())
            select(walls.front());
        m_app->redrawAll();
        shoot("model");
        cloud()->setEnabled(true);
    }

    void exportWithoutOneWall(QAction* exportIfc)
    {
        const auto walls = named<ccMesh>("Wall ");
        select(walls.back());
        check(exportIfc->isEnabled(), "a model's wall can be exported with its model");
        ccHObject* model = walls.back()->getParent()->getParent()->getParent();
        unselectAll();
        m_app->removeFromDB(walls.back());
        select(model);
        whenShown("S2BExportDialog",
                  [](QWidget* dialog)
                  {
                      auto* files = static_cast<QFileDialog*>(dialog);
                      files->findChild<QLineEdit*>("fileNameEdit")
                          ->setText(qEnvironmentVariable("S2B_DRIVER_OUTPUT") + "/without_one_wall.ifc");
                      QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
                  });
        exportIfc->trigger();
        check(QFile::exists(qEnvironmentVariable("S2B_DRIVER_OUTPUT") + "/without_one_wall.ifc"),
              "the corrected model was exported");
        saveAndReport(walls.size() - 1);
    }

    void saveAndReport(std::size_t walls)
    {
        std::printf("walls %zu\n", walls);
        std::fflush(stdout);
    }

    // Cancels at three moments: at once, after a while, and late. Nothing may be left each time.
    void cancel()
    {
        ccHObject::Container before;
        m_app->dbRootObject()->filterChildren(before, true);
        for (const int delay_ms : {0, 400, 1200})
        {
            select(cloud());
            QElapsedTimer sinceCancel;
            QString stage;
            whenShown("S2BReconstructDlg",
                      [&](QWidget* dialog)
                      {
                          dialog->findChild<QCheckBox*>("writeIfc")->setChecked(true);
                          dialog->findChild<QLineEdit*>("ifcPath")->setText(qEnvironmentVariable("S2B_DRIVER_OUTPUT") +
                                                                            "/cancelled.ifc");
                          whenShown("S2BProgress",
                                    [&, delay_ms](QWidget* progress)
                                    {
                                        QTest::qWait(delay_ms);
                                        if (delay_ms == 400)
                                            shoot("cancel");
                                        stage = static_cast<QProgressDialog*>(progress)->labelText();
                                        sinceCancel.start();
                                        QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
                                    });
                          press(dialog, QDialogButtonBox::Ok);
                      });
            action("S2B.Reconstruct")->trigger();
            const bool wasCancelled = sinceCancel.isValid();
            const qint64 taken_ms = wasCancelled ? sinceCancel.elapsed() : -1;
            check(
                wasCancelled && taken_ms < kCancel_ms,
                QString("cancelled after %1 ms, in \"%2\": ended %3 ms later").arg(delay_ms).arg(stage).arg(taken_ms));
            ccHObject::Container after;
            m_app->dbRootObject()->filterChildren(after, true);
            check(after.size() == before.size(), "the tree is as it was");
            check(!QFile::exists(qEnvironmentVariable("S2B_DRIVER_OUTPUT") + "/cancelled.ifc"), "no file was left");
        }
    }

    // A map that does not know the codes must be settled before anything can run.
    void labels()
    {
        select(cloud());
        whenShown("S2BReconstructDlg",
                  [&](QWidget* dialog)
                  {
                      auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
                      auto* field = dialog->findChild<QComboBox*>("labelField");
                      check(!ok->isEnabled(), "codes that the map does not know can't be reconstructed");
                      shoot("dialog_unknown_codes");
                      field->setCurrentIndex(0);
                      check(ok->isEnabled(), "the geometry alone can be");
                      press(dialog, QDialogButtonBox::Cancel);
                  });
        action("S2B.Reconstruct")->trigger();
        check(named<ccMesh>("Wall ").empty(), "closing the dialog runs nothing");
    }

    // The model came back from a .bin file.
    void reopened()
    {
        const auto walls = named<ccMesh>("Wall ");
        check(!walls.empty(), "the walls are there again");
        if (walls.empty())
            return;
        select(walls.front());
        check(action("S2B.ExportIfc")->isEnabled(), "the model can be exported after reopening");
    }

    void reconstructQuietly()
    {
        select(cloud());
        whenShown("S2BReconstructDlg",
                  [](QWidget* dialog)
                  {
                      dialog->findChild<QCheckBox*>("writeIfc")->setChecked(false);
                      press(dialog, QDialogButtonBox::Ok);
                  });
        action("S2B.Reconstruct")->trigger();
    }

    /// The model and the cloud, with the control key held as it were.
    void selectBoth()
    {
        select(model());
        for (auto* view : m_app->getMainWindow()->findChildren<QTreeView*>())
        {
            if (!view->model() || view->model()->rowCount() == 0)
                continue;
            const QModelIndex top = view->model()->index(0, 0);
            for (const QModelIndex& index : view->model()->match(top, Qt::DisplayRole, cloud()->getName(), 1,
                                                                 Qt::MatchExactly | Qt::MatchRecursive))
                view->selectionModel()->select(index, QItemSelectionModel::Select);
        }
        QApplication::processEvents();
    }

    ccHObject* model()
    {
        const auto walls = named<ccMesh>("Wall ");
        return walls.empty() ? nullptr : walls.front()->getParent()->getParent()->getParent();
    }

    std::size_t entityCount()
    {
        ccHObject::Container all;
        m_app->dbRootObject()->filterChildren(all, true);
        return all.size();
    }

    /// Fills the dialog as a user would and presses Validate; `onProgress` runs once the progress is shown.
    void runValidation(const QString& truth, const QString& folder, const QString& picture,
                       const std::function<void(QWidget*)>& onProgress = {})
    {
        selectBoth();
        whenShown("S2BValidateDlg",
                  [=, this](QWidget* dialog)
                  {
                      dialog->findChild<QLineEdit*>("truth")->setText(truth);
                      dialog->findChild<QCheckBox*>("writeReport")->setChecked(true);
                      dialog->findChild<QLineEdit*>("report")->setText(folder);
                      dialog->findChild<QCheckBox*>("openReport")->setChecked(false);
                      auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
                      check(ok->isEnabled() == QFile::exists(truth), "only a truth that is there can be compared with");
                      if (!picture.isEmpty())
                          shoot(picture);
                      if (!ok->isEnabled())
                          return press(dialog, QDialogButtonBox::Cancel);
                      if (onProgress)
                          whenShown("S2BProgress", onProgress);
                      press(dialog, QDialogButtonBox::Ok);
                  });
        action("S2B.Validate")->trigger();
        QTest::qWait(300);
    }

    void validate()
    {
        const QString truth = qEnvironmentVariable("S2B_DRIVER_TRUTH");
        const QString folder = qEnvironmentVariable("S2B_DRIVER_OUTPUT") + "/window_report";
        QAction* validate = action("S2B.Validate");
        check(validate != nullptr, "the action is there");
        unselectAll();
        check(!validate->isEnabled(), "nothing can be validated without a selection");
        reconstructQuietly();
        if (!model())
            return check(false, "there is a model");
        select(model());
        check(validate->isEnabled(), "a model can be validated");
        selectBoth();
        check(m_app->getSelectedEntities().size() == 2 && validate->isEnabled(),
              "a model and a cloud can be validated together");

        // What is wrong, or cancelled, changes nothing.
        const std::size_t before = entityCount();
        runValidation(folder + "/no.ifc", folder, {});
        whenShown("S2BMessage",
                  [this](QWidget* box)
                  {
                      check(static_cast<QMessageBox*>(box)->text().contains("bad.ifc"), "a bad truth is named");
                      shoot("validate_bad_truth");
                      QTest::mouseClick(static_cast<QMessageBox*>(box)->button(QMessageBox::Ok), Qt::LeftButton);
                  });
        runValidation(qEnvironmentVariable("S2B_DRIVER_BAD_TRUTH"), folder, {});
        check(entityCount() == before && !QFile::exists(folder), "a bad truth changes nothing");
        QElapsedTimer sinceCancel;
        runValidation(truth, folder, {},
                      [&](QWidget* progress)
                      {
                          sinceCancel.start();
                          QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
                      });
        check(sinceCancel.isValid() && sinceCancel.elapsed() < kCancel_ms + 300,
              QString("cancelling took %1 ms").arg(sinceCancel.isValid() ? sinceCancel.elapsed() : -1));
        check(entityCount() == before && !QFile::exists(folder), "cancelling leaves nothing");

        const unsigned fields = cloud()->getNumberOfScalarFields();
        runValidation(truth, folder, "validate_dialog");
        check(QFile::exists(folder + "/report.html"), "the report was written");
        check(cloud()->getNumberOfScalarFields() == fields, "the cloud is unchanged");
        checkValidation();
    }

    void checkValidation()
    {
        const auto copies = named<ccPointCloud>(cloud()->getName() + " [deviation]");
        check(copies.size() == 1, "there is a copy of the cloud");
        if (copies.size() != 1)
            return;
        const ccScalarField* field = copies.front()->getCurrentDisplayedScalarField();
        check(field && QString(field->getName()) == "S2B deviation" && copies.front()->sfShown(),
              "it shows its deviations");
        double low = 0.0;
        double high = 0.0;
        if (field && field->getColorScale() && !field->getColorScale()->isRelative())
            field->getColorScale()->getAbsoluteBoundaries(low, high);
        check(high > 0.0 && low == -high, QString("in colours that are symmetric about 0, to %1 m").arg(high));
        std::size_t near = 0;
        for (unsigned i = 0; field && i < field->size(); ++i)
            near += std::abs(field->getValue(i)) < 0.02F ? 1 : 0;
        check(near > copies.front()->size() / 4, QString("%1 points lie on the model").arg(near));
        const auto within = named("Within tolerance");
        check(within.size() == 1 && within.front()->getParent()->getName().endsWith("[validation]"),
              "there is a group of what is within tolerance");
        std::size_t walls = 0;
        for (unsigned i = 0; !within.empty() && i < within.front()->getChildrenNumber(); ++i)
        {
            const ccHObject* element = within.front()->getChild(i);
            walls += element->getMetaData("Class").toString() == "wall" && element->hasMetaData("GUID") ? 1 : 0;
        }
        check(walls > 0, QString("%1 walls are within tolerance").arg(walls));
        unselectAll();
        m_app->setView(CC_ISO_VIEW_1);
        m_app->setGlobalZoom();
        m_app->redrawAll();
        shoot("validation_deviations");
        copies.front()->setEnabled(false);
        if (!within.empty())
            select(within.front()->getChild(0));
        m_app->redrawAll();
        shoot("validation_verdicts");
    }

    QMenu* m_plugins = nullptr;
    int m_failures = 0;
    int m_waits = 0;
};

#include "window_driver.moc"
