// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pipeline/level_survey.h"

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

//! A height with so many decimals, and without the sign of a zero
QString heightText(double height_m, int decimals);

//! The area of horizontal surfaces over height, with a line for each floor and ceiling that can be dragged
class S2BLevelView : public QWidget
{
	Q_OBJECT

  public:
	explicit S2BLevelView(QWidget* parent = nullptr);

	void setProfile(s2b::HeightProfile profile);
	void setStoreys(std::vector<s2b::StoreyHeights> storeys);

	const std::vector<s2b::StoreyHeights>& storeys() const
	{
		return m_storeys;
	}

	//! Where a line is, for those who drag it
	QPoint positionOf(int storey, bool isFloor) const;

	QSize sizeHint() const override;
	QSize minimumSizeHint() const override;

  Q_SIGNALS:
	//! A line was dragged to another height
	void dragged();

  protected:
	void paintEvent(QPaintEvent* event) override;
	void mousePressEvent(QMouseEvent* event) override;
	void mouseMoveEvent(QMouseEvent* event) override;
	void mouseReleaseEvent(QMouseEvent* event) override;

  private:
	struct Line
	{
		int  storey  = 0;
		bool isFloor = true;
	};

	QRect               plot() const;
	double              lowest() const;
	double              highest() const;
	double              heightAt(int y) const;
	int                 yOf(double height_m) const;
	std::optional<Line> lineNear(const QPoint& position) const;
	double&             heightOf(const Line& line);
	void                paintProfile(QPainter& painter) const;
	void                paintAxis(QPainter& painter) const;
	void                paintLines(QPainter& painter) const;

	s2b::HeightProfile              m_profile;
	std::vector<s2b::StoreyHeights> m_storeys;
	std::optional<Line>             m_dragged;
};
