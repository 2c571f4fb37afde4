// SPDX-License-Identifier: GPL-3.0-or-later
// A plugin of the tests alone: drives CloudCompare's window from within and ends it with 1 when a check failed.
//
//   CloudCompare ":start-plugin:S2B_window_driver" scan.bin
//
// S2B_DRIVER_SCENARIO says what to do, S2B_DRIVER_OUTPUT where the screenshots go.
#include "driver.h"

#include <QListWidget>
#include <QToolBar>

#include <memory>

#include <ccStdPluginInterface.h>

namespace
{

constexpr int kStart_ms = 1500;       // CloudCompare has shown its window by then, and mostly opened the file
constexpr int kOpenTries = 40;        // a large file on a busy machine
constexpr int kWatchdog_ms = 240000;  // far above any scenario: a hang has to end the test
constexpr int kCycle_ms = 3000;       // the same for each cycle of one that repeats something

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
        m_driver = std::make_unique<Driver>(*m_app);
        QTimer::singleShot(kStart_ms, this, &WindowDriver::run);
        QTimer::singleShot(slowdown() * (kWatchdog_ms + kCycle_ms * qEnvironmentVariableIntValue("S2B_DRIVER_CYCLES")),
                           this,
                           [this]
                           {
                               m_driver->check(false, "the scenario ended in time");
                               finish();
                           });
        return true;
    }

private:
    void finish() { QCoreApplication::exit(m_driver->failures() ? 1 : 0); }

    /// What is not CloudCompare's or ours, or of this machine, has no place on a picture.
    void tidyUp()
    {
        for (auto* bar : m_app->getMainWindow()->findChildren<QToolBar*>())
        {
            for (QAction* action : bar->actions())
            {
                if (action->text() == getName())
                    bar->removeAction(action);
            }
            if (bar->actions().isEmpty())
                bar->hide();
        }
        if (auto* console = m_app->getMainWindow()->findChild<QListWidget*>("consoleWidget"))
            console->clear();
        if (ccPointCloud* cloud = m_driver->cloud())
            cloud->getParent()->setName("scan.bin");
    }

    void run()
    {
        Driver& driver = *m_driver;
        if (!driver.cloud() &&
            ++m_waits < kOpenTries)  // still loading: events are handled meanwhile, but the window does not run yet
        {
            QTimer::singleShot(kStart_ms, this, &WindowDriver::run);
            return;
        }
        m_app->getMainWindow()->resize(1400, 900);
        m_app->getMainWindow()->move(0, 0);
        tidyUp();
        const Scenario::Function scenario = Scenario::find(qEnvironmentVariable("S2B_DRIVER_SCENARIO"));
        driver.check(driver.cloud() != nullptr, "the cloud is open");
        driver.check(driver.menu() != nullptr, "Plugins > Scan to BIM is there");
        driver.check(scenario != nullptr, "the scenario is known");
        if (!driver.failures())
            scenario(driver);
        finish();
    }

    std::unique_ptr<Driver> m_driver;
    int m_waits = 0;
};

#include "window_driver.moc"
