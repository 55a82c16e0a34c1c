"""For ParaView 5.11 with Python 3.11, as Debian 12 has them: ParaView asks for inspect.getargspec, which Python no longer has, and so loads no
plugin that is written in Python. With this folder in PYTHONPATH it does. Elsewhere this changes nothing."""
import collections
import inspect

if not hasattr(inspect, "getargspec"):
    _ArgSpec = collections.namedtuple("ArgSpec", "args varargs keywords defaults")
    inspect.getargspec = lambda function: _ArgSpec(*inspect.getfullargspec(function)[:4])   # type: ignore[attr-defined]
