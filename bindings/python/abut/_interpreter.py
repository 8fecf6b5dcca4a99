"""Refuses sub-interpreters, before anything is loaded that is there once for the whole process."""

import ctypes


def require_main_interpreter() -> None:
    """Raises ImportError in a sub-interpreter. A module that is loaded there would take the types
    of the compiled part away from the main interpreter."""
    current = ctypes.pythonapi.PyInterpreterState_Get
    current.restype = ctypes.c_void_p
    number = ctypes.pythonapi.PyInterpreterState_GetID
    number.argtypes, number.restype = [ctypes.c_void_p], ctypes.c_int64
    if number(current()) != 0:
        raise ImportError(
            "abut does not support sub-interpreters: import it in the main interpreter, or in a "
            "process of its own"
        )


require_main_interpreter()
