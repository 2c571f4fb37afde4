<?xml version="1.0" encoding="UTF-8"?>
<Markup>
  <Header>
{{#FILE}}    <File isExternal="true">
      <Filename>{{NAME:xml_escape}}</Filename>
      <Date>{{DATE:xml_escape}}</Date>
    </File>
{{/FILE}}  </Header>
  <Topic Guid="{{TOPIC:xml_escape}}" TopicType="{{TYPE:xml_escape}}" TopicStatus="Open">
    <Title>{{TITLE:xml_escape}}</Title>
    <Priority>{{PRIORITY:xml_escape}}</Priority>
    <Index>{{INDEX:xml_escape}}</Index>
{{#LABEL}}    <Labels>{{TEXT:xml_escape}}</Labels>
{{/LABEL}}    <CreationDate>{{DATE:xml_escape}}</CreationDate>
    <CreationAuthor>{{AUTHOR:xml_escape}}</CreationAuthor>
    <Description>{{DESCRIPTION:xml_escape}}</Description>
  </Topic>
  <Viewpoints Guid="{{VIEWPOINT:xml_escape}}">
    <Viewpoint>viewpoint.bcfv</Viewpoint>
    <Snapshot>snapshot.png</Snapshot>
    <Index>0</Index>
  </Viewpoints>
</Markup>
