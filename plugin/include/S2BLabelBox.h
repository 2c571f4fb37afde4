// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BInput.h"

#include <QGroupBox>
#include <vector>

class QComboBox;
class QLabel;
class QSettings;
class QTreeWidget;
class ccPointCloud;

//! Which scalar field holds the labels and what its codes mean, with the classes that are found and their counts
class S2BLabelBox : public QGroupBox
{
	Q_OBJECT

  public:
	explicit S2BLabelBox(std::vector<const ccPointCloud*> clouds, QWidget* parent = nullptr);

	s2b::LabelChoice choice() const;

	//! Whether the map knows every code of the field; true without a field
	bool fits() const
	{
		return m_fits;
	}

	void readSettings(const QSettings& settings);
	void writeSettings(QSettings& settings) const;

  Q_SIGNALS:
	void changed();

  private:
	void update();
	void browse();
	void complain(const QString& text);

	std::vector<const ccPointCloud*> m_clouds;
	s2b::LabelMap                    m_map;
	bool                             m_fits    = true;
	QComboBox*                       m_field   = nullptr;
	QComboBox*                       m_mapName = nullptr;
	QTreeWidget*                     m_classes = nullptr;
	QLabel*                          m_hint    = nullptr;
};
