// SPDX-License-Identifier: GPL-3.0-or-later
#include "processor_time.h"

#include <QDir>
#include <QFile>

#include <algorithm>

#include <unistd.h>

/// Milliseconds of each thread of this process so far, by thread id (proc(5): utime and stime of task/<tid>/stat).
std::map<int, qint64> ProcessorTime::threads()
{
    const qint64 tick_ms = 1000 / sysconf(_SC_CLK_TCK);
    std::map<int, qint64> times;
    const QDir tasks("/proc/self/task");
    for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
    {
        QFile file(tasks.filePath(task + "/stat"));
        if (!file.open(QIODevice::ReadOnly))
            continue;  // ended meanwhile
        // The name in brackets may hold blanks: the fields are counted from behind it.
        const QByteArray text = file.readAll();
        const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
        if (fields.size() > 12)
            times[task.toInt()] = (fields[11].toLongLong() + fields[12].toLongLong()) * tick_ms;
    }
    return times;
}

void ProcessorTime::start()
{
    m_before = threads();
    m_elapsed.start();
}

qint64 ProcessorTime::busiest_ms() const
{
    qint64 busiest = 0;
    for (const auto& [thread, time_ms] : threads())
    {
        const auto before = m_before.find(thread);
        busiest = std::max(busiest, time_ms - (before == m_before.end() ? 0 : before->second));
    }
    return busiest;
}
