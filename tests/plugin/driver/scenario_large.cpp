// SPDX-License-Identifier: GPL-3.0-or-later
// A measurement: how long the window does not answer while a cloud is reconstructed, and the memory that it takes.
#include "driver.h"

#include <ctime>

#include <malloc.h>

namespace
{

constexpr int kTick_ms = 5;

/// A line of /proc/self/status [MB] (proc(5)).
double memory_MB(const QByteArray& key)
{
    QFile file("/proc/self/status");
    file.open(QIODevice::ReadOnly);
    for (const QByteArray& line : file.readAll().split('\n'))
        if (line.startsWith(key + ":"))
            return line.mid(key.size() + 1).simplified().split(' ').front().toDouble() / 1024.0;
    return 0;
}

/// The most that was held at a time is counted from now on.
void resetPeak()
{
    QFile file("/proc/self/clear_refs");
    if (file.open(QIODevice::WriteOnly))
        file.write("5");
}

qint64 seconds_ms(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return 1000 * time.tv_sec + time.tv_nsec / 1000000;
}

/// What the window's thread does at a stretch, in each of the phases of a run: until it is through, nothing answers.
class Turns
{
public:
    Turns()
    {
        QObject::connect(&m_timer, &QTimer::timeout, [this] { turn(); });
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.start(kTick_ms);
    }

    /// A turn that has not ended belongs to the phase before.
    void begin(const QString& phase)
    {
        turn();
        m_phases.push_back({phase});
        m_since.start();
        m_processor_ms = seconds_ms(CLOCK_PROCESS_CPUTIME_ID);
        resetPeak();
    }

    /// The work of a turn is what it would take on an idle machine, the gap what it took on this one.
    void print()
    {
        turn();
        for (const Phase& p : m_phases)
            std::printf(
                "%-26s %6lld ms, %6lld ms of all cores, at most %5.0f MB, longest turn %4lld ms of work, %4lld ms "
                "gap\n",
                qPrintable(p.name), static_cast<long long>(p.elapsed_ms), static_cast<long long>(p.processor_ms),
                p.peak_MB, static_cast<long long>(p.work_ms), static_cast<long long>(p.gap_ms));
    }

private:
    struct Phase
    {
        QString name;
        qint64 elapsed_ms = 0;
        qint64 processor_ms = 0;
        qint64 work_ms = 0;
        qint64 gap_ms = 0;
        double peak_MB = 0;
    };

    void turn()
    {
        const qint64 work = seconds_ms(CLOCK_THREAD_CPUTIME_ID);
        const qint64 now = seconds_ms(CLOCK_MONOTONIC);
        if (!m_phases.empty())
        {
            Phase& p = m_phases.back();
            p.elapsed_ms = m_since.elapsed();
            p.processor_ms = seconds_ms(CLOCK_PROCESS_CPUTIME_ID) - m_processor_ms;
            p.work_ms = std::max(p.work_ms, work - m_work_ms);
            p.gap_ms = std::max(p.gap_ms, now - m_now_ms);
            p.peak_MB = memory_MB("VmHWM");
        }
        m_work_ms = work;
        m_now_ms = now;
    }

    QTimer m_timer;
    QElapsedTimer m_since;
    qint64 m_processor_ms = 0;
    qint64 m_work_ms = 0;
    qint64 m_now_ms = 0;
    std::vector<Phase> m_phases;
};

void large(Driver& driver)
{
    // The cloud's own drawing is CloudCompare's, and takes its time without a graphics card.
    driver.cloud()->setEnabled(false);
    driver.select(driver.cloud());
    driver.app().redrawAll();
    QTest::qWait(1000);
    Turns turns;
    turns.begin("before");
    QTest::qWait(100);
    turns.begin("opening the dialog");
    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         dialog->findChild<QCheckBox*>("writeIfc")->setChecked(false);
                         auto* storeys = dialog->findChild<QTableWidget*>("storeys");
                         turns.begin("its page of the levels");
                         dialog->findChild<QTabWidget*>("tabs")->setCurrentIndex(1);
                         driver.check(driver.waitFor([&] { return storeys->rowCount() > 0; }), "the storeys are found");
                         driver.whenShown("S2BProgress",
                                          [&](QWidget* progress)
                                          {
                                              QObject::connect(progress, &QObject::destroyed, &driver,
                                                               [&] { turns.begin("the result in the tree"); });
                                          });
                         turns.begin("the run");
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    driver.action("S2B.Reconstruct")->trigger();
    turns.begin("after");
    QTest::qWait(1000);
    turns.print();
    malloc_trim(0);
    std::printf("%u points, %zu elements; %.0f MB when what is free was given back\n", driver.cloud()->size(),
                driver.named<ccMesh>(QString()).size(), memory_MB("VmRSS"));
    driver.check(driver.model() != nullptr, "there is a model");
    driver.shoot("large");
}

const Scenario kScenario("large", large);

}  // namespace
