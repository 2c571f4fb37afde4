// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BMemory.h"

#include <QFile>
#include <chrono>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace s2b
{
	namespace
	{
		double now_s()
		{
			return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
		}

		// A line "VmHWM:  123456 kB" of the process' status, in bytes; 0 where there is none.
		double statusValue_b(const char* key)
		{
			QFile status("/proc/self/status");
			if (!status.open(QIODevice::ReadOnly))
				return 0;
			for (const QByteArray& line : status.readAll().split('\n'))
			{
				if (line.startsWith(key))
					return 1024.0 * line.mid(static_cast<int>(qstrlen(key)) + 1).trimmed().split(' ').front().toDouble();
			}
			return 0;
		}
	} // namespace

	StepMeter::StepMeter()
	    : m_start_s(now_s())
	{
		// Loading a file may have peaked higher than the step that is measured: the mark starts anew.
		QFile reset("/proc/self/clear_refs");
		if (reset.open(QIODevice::WriteOnly))
			reset.write("5");
		reset.close();
		m_before_b = statusValue_b("VmRSS");
	}

	QString StepMeter::text() const
	{
		constexpr double kGiga = 1.0e9;
		return QString("%1 s, peak memory %2 GB (%3 GB before)")
		    .arg(now_s() - m_start_s, 0, 'f', 2)
		    .arg(statusValue_b("VmHWM") / kGiga, 0, 'f', 2)
		    .arg(m_before_b / kGiga, 0, 'f', 2);
	}

	void returnFreeMemory()
	{
#ifdef __GLIBC__
		malloc_trim(0);
#endif
	}
} // namespace s2b
