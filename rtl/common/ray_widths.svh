// The parameters of a ray's numbers, and the widths that follow; stands first in the parameter lists of the modules that
// a ray passes. As in models/rays/machine_ray.h (NumberFormat, MapShape).
    parameter int MaxLevel = 10,       // n of the largest map: 2^n texels on a side
    parameter int HeightBits = 8,      // B
    parameter int FractionBits = 8,    // f
    parameter int DirectionBits = 32,  // D
    parameter int MantissaBits = 12,   // M
    parameter int TileBits = 4,        // w2
    parameter int IdBits = 32,
    // Widths that follow.
    parameter int IndexBits = MaxLevel + TileBits,
    parameter int PositionBits = IndexBits + FractionBits + 2,
    parameter int PlaneBits = IndexBits + 3,
    parameter int SpaceBits = (IndexBits + 2 > HeightBits + 1) ? IndexBits + 2 : HeightBits + 1,
    parameter int ProductBits = SpaceBits + FractionBits + MantissaBits + 2,
    parameter int TimeBits =
        ((IndexBits > HeightBits) ? IndexBits : HeightBits) + FractionBits + MantissaBits,
    parameter int ShiftBits = $clog2(DirectionBits),
