// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BLevelView.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace
{
	constexpr int    kAxis_px      = 54; // for the heights
	constexpr int    kNames_px     = 150;
	constexpr int    kEdge_px      = 12;
	constexpr int    kReach_px     = 6;   // of the mouse to a line
	constexpr double kLowestRoom_m = 0.5; // a floor and its ceiling are not dragged nearer than this
	constexpr double kMargin_m     = 0.3; // above and below the profile
	const QColor     kFloorColor   = QColor(0x3f, 0x7f, 0xbf);
	const QColor     kCeilingColor = QColor(0xd9, 0x7b, 0x29);
	const QColor     kProfileColor = QColor(0x9a, 0xa8, 0xb8);
	const QColor     kRoomColor    = QColor(0x3f, 0x7f, 0xbf, 24);

	// The step of an axis' marks: 1, 2 or 5 times a power of ten.
	double niceStep(double span, int marks)
	{
		const double rough = span / std::max(1, marks);
		const double power = std::pow(10.0, std::floor(std::log10(rough)));
		for (const double factor : {1.0, 2.0, 5.0})
		{
			if (factor * power >= rough)
				return factor * power;
		}
		return 10.0 * power;
	}

	QString metres(double height_m)
	{
		return heightText(height_m, 2) + " m";
	}
} // namespace

QString heightText(double height_m, int decimals)
{
	const QString text = QString::number(height_m, 'f', decimals);
	return text.toDouble() == 0.0 ? QString::number(0.0, 'f', decimals) : text;
}

S2BLevelView::S2BLevelView(QWidget* parent)
    : QWidget(parent)
{
	setObjectName("levelView");
	setMouseTracking(true);
	setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void S2BLevelView::setProfile(s2b::HeightProfile profile)
{
	m_profile = std::move(profile);
	update();
}

void S2BLevelView::setStoreys(std::vector<s2b::StoreyHeights> storeys)
{
	m_storeys = std::move(storeys);
	m_dragged.reset();
	update();
}

QSize S2BLevelView::sizeHint() const
{
	return {420, 360};
}

QSize S2BLevelView::minimumSizeHint() const
{
	return {320, 220};
}

QRect S2BLevelView::plot() const
{
	return rect().adjusted(kAxis_px, kEdge_px, -kNames_px, -kEdge_px);
}

// What was scanned, and what was added above it by hand.
double S2BLevelView::lowest() const
{
	return std::min(m_profile.low_m, m_storeys.empty() ? m_profile.low_m : m_storeys.front().floor_m) - kMargin_m;
}

double S2BLevelView::highest() const
{
	return std::max(m_profile.high_m(), m_storeys.empty() ? m_profile.high_m() : m_storeys.back().ceiling_m) + kMargin_m;
}

int S2BLevelView::yOf(double height_m) const
{
	const QRect area = plot();
	return area.bottom() - static_cast<int>(std::lround((height_m - lowest()) / (highest() - lowest()) * area.height()));
}

double S2BLevelView::heightAt(int y) const
{
	const QRect area = plot();
	return lowest() + (highest() - lowest()) * (area.bottom() - y) / area.height();
}

QPoint S2BLevelView::positionOf(int storey, bool isFloor) const
{
	const s2b::StoreyHeights& heights = m_storeys.at(static_cast<std::size_t>(storey));
	return {plot().center().x(), yOf(isFloor ? heights.floor_m : heights.ceiling_m)};
}

double& S2BLevelView::heightOf(const Line& line)
{
	s2b::StoreyHeights& heights = m_storeys[static_cast<std::size_t>(line.storey)];
	return line.isFloor ? heights.floor_m : heights.ceiling_m;
}

std::optional<S2BLevelView::Line> S2BLevelView::lineNear(const QPoint& position) const
{
	std::optional<Line> nearest;
	int                 best = kReach_px;
	for (int i = 0; i < static_cast<int>(m_storeys.size()); ++i)
	{
		for (const bool isFloor : {true, false})
		{
			const int distance = std::abs(positionOf(i, isFloor).y() - position.y());
			if (distance <= best)
			{
				best    = distance;
				nearest = Line{i, isFloor};
			}
		}
	}
	return position.x() >= plot().left() ? nearest : std::nullopt;
}

void S2BLevelView::mousePressEvent(QMouseEvent* event)
{
	if (event->button() == Qt::LeftButton)
		m_dragged = lineNear(event->pos());
}

void S2BLevelView::mouseMoveEvent(QMouseEvent* event)
{
	if (!m_dragged)
	{
		setCursor(lineNear(event->pos()) ? Qt::SizeVerCursor : Qt::ArrowCursor);
		return;
	}
	// A line stays between its neighbours, and a room stays a room.
	const auto& self  = m_storeys[static_cast<std::size_t>(m_dragged->storey)];
	const int   below = m_dragged->storey - 1;
	const auto  above = static_cast<std::size_t>(m_dragged->storey) + 1;
	double      low   = heightAt(plot().bottom());
	double      high  = heightAt(plot().top());
	if (m_dragged->isFloor)
	{
		high = self.ceiling_m - kLowestRoom_m;
		if (below >= 0)
			low = m_storeys[static_cast<std::size_t>(below)].ceiling_m;
	}
	else
	{
		low = self.floor_m + kLowestRoom_m;
		if (above < m_storeys.size())
			high = m_storeys[above].floor_m;
	}
	if (low > high)
		return;
	heightOf(*m_dragged) = std::clamp(std::round(heightAt(event->pos().y()) * 1000.0) / 1000.0, low, high);
	update();
	Q_EMIT dragged();
}

void S2BLevelView::mouseReleaseEvent(QMouseEvent*)
{
	m_dragged.reset();
}

void S2BLevelView::paintProfile(QPainter& painter) const
{
	if (m_profile.area_m2.empty())
		return;
	// One bar for each row of pixels, as long as the largest bin in it; a square root keeps small ceilings visible.
	const QRect         area = plot();
	std::vector<double> rows(static_cast<std::size_t>(area.height()) + 1, 0.0);
	double              largest = 0.0;
	for (std::size_t i = 0; i < m_profile.area_m2.size(); ++i)
	{
		const double z      = m_profile.low_m + static_cast<double>(i) * m_profile.bin_m;
		const int    top    = yOf(z + m_profile.bin_m) - area.top();
		const int    bottom = yOf(z) - area.top();
		for (int row = std::max(0, top); row <= std::min(area.height(), std::max(top, bottom - 1)); ++row)
			rows[static_cast<std::size_t>(row)] = std::max(rows[static_cast<std::size_t>(row)], m_profile.area_m2[i]);
		largest = std::max(largest, m_profile.area_m2[i]);
	}
	if (largest <= 0.0)
		return;
	for (std::size_t row = 0; row < rows.size(); ++row)
	{
		const int length = static_cast<int>(std::sqrt(rows[row] / largest) * area.width());
		if (length)
			painter.fillRect(area.left(), area.top() + static_cast<int>(row), length, 1, kProfileColor);
	}
}

void S2BLevelView::paintAxis(QPainter& painter) const
{
	const QRect  area = plot();
	const double low  = heightAt(area.bottom());
	const double high = heightAt(area.top());
	const double step = niceStep(high - low, area.height() / 40);
	painter.setPen(palette().color(QPalette::Mid));
	painter.drawLine(area.topLeft(), area.bottomLeft());
	for (double z = std::ceil(low / step) * step; z <= high; z += step)
	{
		const int y = yOf(z);
		painter.setPen(palette().color(QPalette::Mid));
		painter.drawLine(area.left() - 4, y, area.left(), y);
		painter.setPen(palette().color(QPalette::Text));
		painter.drawText(QRect(0, y - 10, kAxis_px - 8, 20), Qt::AlignRight | Qt::AlignVCenter, QString::number(std::abs(z) < 1e-9 ? 0.0 : z, 'f', step < 1.0 ? 1 : 0));
	}
}

void S2BLevelView::paintLines(QPainter& painter) const
{
	const QRect area       = plot();
	int         lastY      = height() + 100; // of the name below, so that none lies over another
	const int   lineHeight = fontMetrics().height();
	for (int i = 0; i < static_cast<int>(m_storeys.size()); ++i)
	{
		const s2b::StoreyHeights& storey  = m_storeys[static_cast<std::size_t>(i)];
		const int                 floor   = yOf(storey.floor_m);
		const int                 ceiling = yOf(storey.ceiling_m);
		painter.fillRect(QRect(QPoint(area.left(), ceiling), QPoint(area.right(), floor)), kRoomColor);
		struct Name
		{
			bool    isFloor;
			int     y;
			QString text;
		};
		const std::array<Name, 2> names{{{true, floor, QString("Floor %1  %2").arg(i).arg(metres(storey.floor_m))}, {false, ceiling, QString("Ceiling %1  %2").arg(i).arg(metres(storey.ceiling_m))}}};
		for (const Name& name : names)
		{
			const QColor color    = name.isFloor ? kFloorColor : kCeilingColor;
			const bool   isMoving = m_dragged && m_dragged->storey == i && m_dragged->isFloor == name.isFloor;
			QPen         pen(color, isMoving ? 3 : 2);
			if (!name.isFloor && !storey.ceilingSeen)
				pen.setStyle(Qt::DashLine);
			const int textY = std::min(name.y, lastY - lineHeight);
			lastY           = textY;
			painter.setPen(pen);
			painter.drawLine(area.left(), name.y, area.right(), name.y);
			painter.setPen(QPen(color, 1));
			painter.drawLine(area.right(), name.y, area.right() + 12, textY);
			painter.setBrush(color);
			painter.drawRoundedRect(QRect(area.right() - 4, name.y - 4, 8, 8), 2, 2); // to grasp
			painter.drawText(QRect(area.right() + 16, textY - lineHeight, kNames_px, 2 * lineHeight), Qt::AlignLeft | Qt::AlignVCenter, name.text);
		}
	}
}

void S2BLevelView::paintEvent(QPaintEvent*)
{
	QPainter painter(this);
	painter.fillRect(rect(), palette().color(QPalette::Base));
	if (m_profile.area_m2.empty())
		return;
	painter.setRenderHint(QPainter::Antialiasing, false);
	paintProfile(painter);
	paintAxis(painter);
	painter.setRenderHint(QPainter::Antialiasing);
	paintLines(painter);
}
