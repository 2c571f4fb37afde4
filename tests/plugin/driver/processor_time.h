// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>

#include <map>

/// Measures how long something takes to happen as an idle machine would: by the processor time of the busiest thread.
///
/// On an idle machine a thread that works is never kept waiting, so its processor time is the time that passes. On a
/// machine that others keep busy the time that passes is theirs too. A wait for something else than the processor is
/// not seen in it: the time that passed has a bound as well, a wide one.
class ProcessorTime
{
public:
    void start();
    [[nodiscard]] bool isRunning() const { return m_elapsed.isValid(); }
    [[nodiscard]] qint64 busiest_ms() const;
    [[nodiscard]] qint64 elapsed_ms() const { return m_elapsed.isValid() ? m_elapsed.elapsed() : -1; }

private:
    static std::map<int, qint64> threads();

    std::map<int, qint64> m_before;
    QElapsedTimer m_elapsed;
};
