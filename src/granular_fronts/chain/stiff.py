import math
STIFF = 80.0
def suits(run, stiff_from=STIFF): return False
