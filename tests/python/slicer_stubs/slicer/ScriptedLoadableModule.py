import types

from slicer import Widget


class ScriptedLoadableModule:
    def __init__(self, parent):
        self.parent = parent


class ScriptedLoadableModuleWidget:
    def __init__(self, parent=None):
        self.layout = Widget()

    def setup(self):
        pass


class ScriptedLoadableModuleLogic:
    pass


Parent = types.SimpleNamespace
