<?xml version="1.0" encoding="UTF-8"?>
<Markup>
  <Header>
{{#FILE}}    <File isExternal="true">
      <Filename>{{NAME:x}}</Filename>
      <Date>{{DATE:x}}</Date>
    </File>
{{/FILE}}  </Header>
  <Topic Guid="{{TOPIC:x}}" TopicType="{{TYPE:x}}" TopicStatus="Open">
    <Title>{{TITLE:x}}</Title>
    <Priority>{{PRIORITY:x}}</Priority>
    <Index>{{INDEX:x}}</Index>
{{#LABEL}}    <Labels>{{TEXT:x}}</Labels>
{{/LABEL}}    <CreationDate>{{DATE:x}}</CreationDate>
    <CreationAuthor>{{AUTHOR:x}}</CreationAuthor>
    <Description>{{DESCRIPTION:x}}</Description>
  </Topic>
  <Viewpoints Guid="{{VIEWPOINT:x}}">
    <Viewpoint>viewpoint.bcfv</Viewpoint>
    <Snapshot>snapshot.png</Snapshot>
    <Index>0</Index>
  </Viewpoints>
</Markup>
