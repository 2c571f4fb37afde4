// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BLasHeader.h"

#include <QFile>
#include <QtEndian>

namespace s2b
{
	namespace
	{
		// Offsets of the LAS 1.4 specification's public header block
		constexpr int kMinorVersion = 25;
		constexpr int kLegacyCount  = 107; // 32 bits, all versions
		constexpr int kCount        = 247; // 64 bits, from 1.4 on
		constexpr int kSize         = 375;
	} // namespace

	std::optional<quint64> lasPointCount(const QString& path)
	{
		QFile file(path);
		if (!file.open(QIODevice::ReadOnly))
			return {};
		const QByteArray header = file.read(kSize);
		if (!header.startsWith("LASF") || header.size() < kLegacyCount + 4)
			return {};
		const quint64 legacy = qFromLittleEndian<quint32>(header.constData() + kLegacyCount);
		if (header[kMinorVersion] < 4 || header.size() < kSize)
			return legacy;
		return std::max(legacy, qFromLittleEndian<quint64>(header.constData() + kCount));
	}
} // namespace s2b
