<?xml version="1.0" encoding="UTF-8"?>
<VisualizationInfo Guid="{{VIEWPOINT:x}}">
  <Components>
{{#SELECTION}}    <Selection>
{{#COMPONENT}}      <Component IfcGuid="{{GUID:x}}"/>
{{/COMPONENT}}    </Selection>
{{/SELECTION}}    <Visibility DefaultVisibility="true"/>
  </Components>
  <PerspectiveCamera>
    <CameraViewPoint>
      <X>{{EYE_X:x}}</X>
      <Y>{{EYE_Y:x}}</Y>
      <Z>{{EYE_Z:x}}</Z>
    </CameraViewPoint>
    <CameraDirection>
      <X>{{DIRECTION_X:x}}</X>
      <Y>{{DIRECTION_Y:x}}</Y>
      <Z>{{DIRECTION_Z:x}}</Z>
    </CameraDirection>
    <CameraUpVector>
      <X>{{UP_X:x}}</X>
      <Y>{{UP_Y:x}}</Y>
      <Z>{{UP_Z:x}}</Z>
    </CameraUpVector>
    <FieldOfView>{{FIELD_OF_VIEW:x}}</FieldOfView>
  </PerspectiveCamera>
</VisualizationInfo>
