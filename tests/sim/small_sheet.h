// A sheet of 18×24 cells that is lit at a corner: small enough to be burnt down many times.
#pragma once

#include "sim/params.h"

namespace ember::test {

/// Burns, shrinks and cracks within three seconds; its fire has passed its peak after four.
inline Params small_sheet() {
    Params p;
    p.sheet.rows = 18;
    p.sheet.columns = 24;
    p.sheet.width = 0.118;
    p.sheet.height = 0.149;
    p.lighter.x = -0.055;
    p.lighter.y = 0.28;
    return p;
}

}  // namespace ember::test
