// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

namespace
{

void chooseModel(QWidget* dialog, const QString& path)
{
    auto* own = dialog->findChild<QRadioButton*>("own");
    own->setChecked(true);
    dialog->findChild<QLineEdit*>("modelPath")->setText(path);
}

// Labels a cloud with a model, looks at what came of it, cancels another run, and reconstructs from the labels.
void segment(Driver& driver)
{
    ccPointCloud* cloud = driver.cloud();
    const unsigned fields = cloud->getNumberOfScalarFields();
    const QString model = qEnvironmentVariable("S2B_DRIVER_MODEL");
    driver.unselectAll();
    driver.check(!driver.action("S2B.Segment")->isEnabled(), "without a selection there is nothing to segment");
    driver.select(cloud);
    driver.whenShown("S2BSegmentDlg",
                     [&](QWidget* dialog)
                     {
                         auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
                         driver.shoot(dialog, "segment_dialog");
                         chooseModel(dialog, qEnvironmentVariable("S2B_DRIVER_BAD_MODEL"));
                         driver.check(!ok->isEnabled(), "a file that is no model can't be used");
                         driver.check(dialog->findChild<QLabel*>("hint")->text().contains("no ONNX model"),
                                      "and the dialog says why");
                         chooseModel(dialog, model);
                         driver.check(ok->isEnabled(), "a model can be used");
                         driver.check(dialog->findChild<QLabel*>("model")->text().contains("floor, ceiling, wall"),
                                      "its classes are shown");
                         driver.shoot(dialog, "segment_dialog_own_model");
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    driver.action("S2B.Segment")->trigger();
    driver.check(cloud->getNumberOfScalarFields() == fields + 2, "two scalar fields were added");
    const int index = cloud->getScalarFieldIndexByName("S2B class");
    driver.check(index >= 0 && cloud->getScalarFieldIndexByName("S2B confidence") >= 0, "class and confidence");
    if (index < 0)
        return;
    const auto* classes = static_cast<ccScalarField*>(cloud->getScalarField(index));
    driver.check(cloud->getCurrentDisplayedScalarFieldIndex() == index && cloud->sfShown(), "the classes are shown");
    driver.check(classes->getColorScale()->getName() == "S2B classes" && !classes->getColorScale()->isRelative(),
                 "in a scale of their own");
    std::array<std::size_t, 11> counts{};
    for (const ScalarType value : *classes)
        ++counts.at(static_cast<std::size_t>(value));
    const auto share = [&](std::size_t code)
    { return static_cast<double>(counts[code]) / static_cast<double>(classes->currentSize()); };
    driver.check(share(1) > 0.05 && share(2) > 0.05 && share(3) > 0.2, "floor, ceiling and walls were found");
    driver.unselectAll();
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.app().redrawAll();
    driver.shoot("segment_result");

    // Once more, cancelled at once: the fields stay as they are.
    ProcessorTime sinceCancel;
    driver.select(cloud);
    driver.whenShown("S2BSegmentDlg",
                     [&](QWidget* dialog)
                     {
                         driver.check(dialog->findChild<QLineEdit*>("modelPath")->text() == model,
                                      "the model is remembered");
                         driver.whenShown("S2BProgress",
                                          [&](QWidget* progress)
                                          {
                                              sinceCancel.start();
                                              QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
                                          });
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    driver.action("S2B.Segment")->trigger();
    driver.checkCancelled(sinceCancel, "while labelling");
    driver.check(cloud->getNumberOfScalarFields() == fields + 2 && cloud->getScalarField(index) == classes,
                 "a cancelled run changes nothing");

    driver.select(cloud);
    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         auto* field = dialog->findChild<QComboBox*>("labelField");
                         driver.check(field->currentText() == "S2B class", "the model's labels are what is offered");
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    driver.action("S2B.Reconstruct")->trigger();
    driver.check(!driver.named<ccMesh>("Wall ").empty(), "walls come of them");
}

const Scenario kScenario("segment", segment);

}  // namespace
