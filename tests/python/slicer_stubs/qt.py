from slicer import Widget

QFormLayout = QLabel = QLineEdit = QPushButton = Widget
