// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace s2b
{
	//! Measures the time and the peak memory of a step, on Linux
	class StepMeter
	{
	  public:
		StepMeter();
		//! "3.2 s, peak memory 1.20 GB (0.40 GB before)"
		QString text() const;

	  private:
		double m_start_s  = 0;
		double m_before_b = 0;
	};

	//! Gives what is free back to the system
	/** glibc keeps it for the threads that took it, which a run's are not used for again **/
	void returnFreeMemory();
} // namespace s2b
