from slicer import Widget

ctkCollapsibleButton = ctkPathLineEdit = Widget
