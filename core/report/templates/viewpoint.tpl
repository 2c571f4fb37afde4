<?xml version="1.0" encoding="UTF-8"?>
<VisualizationInfo Guid="{{VIEWPOINT:xml_escape}}">
  <Components>
{{#SELECTION}}    <Selection>
{{#COMPONENT}}      <Component IfcGuid="{{GUID:xml_escape}}"/>
{{/COMPONENT}}    </Selection>
{{/SELECTION}}    <Visibility DefaultVisibility="true"/>
  </Components>
  <PerspectiveCamera>
    <CameraViewPoint>
      <X>{{EYE_X:xml_escape}}</X>
      <Y>{{EYE_Y:xml_escape}}</Y>
      <Z>{{EYE_Z:xml_escape}}</Z>
    </CameraViewPoint>
    <CameraDirection>
      <X>{{DIRECTION_X:xml_escape}}</X>
      <Y>{{DIRECTION_Y:xml_escape}}</Y>
      <Z>{{DIRECTION_Z:xml_escape}}</Z>
    </CameraDirection>
    <CameraUpVector>
      <X>{{UP_X:xml_escape}}</X>
      <Y>{{UP_Y:xml_escape}}</Y>
      <Z>{{UP_Z:xml_escape}}</Z>
    </CameraUpVector>
    <FieldOfView>{{FIELD_OF_VIEW:xml_escape}}</FieldOfView>
  </PerspectiveCamera>
</VisualizationInfo>
