#pragma once

#include "models/algorithms/schedule.h"
#include "models/rays/hit.h"
#include "sim/hardware/hmt_registers.h"
#include "sim/hardware/hmt_top_port.h"
#include "sim/hardware/rtl_set.h"

// What model and hardware must spell alike, held together when a set is compiled: the words and the register map of
// Verilator's $unit, and the widths that follow from a set's parameters.

namespace cuesta::rtl {

/// Compiles where the words of the Verilated $unit `Unit` are the model's.
template <class Unit>
constexpr bool words_are_tied() {
  static_assert(Unit::HmtStartRoot == static_cast<int>(StartRule::kRoot));
  static_assert(Unit::HmtStartLeaf == static_cast<int>(StartRule::kLeaf));
  static_assert(Unit::HmtStartSpan == static_cast<int>(StartRule::kSpan));
  static_assert(Unit::HmtUpNever == static_cast<int>(UpRule::kNever));
  static_assert(Unit::HmtUpAlways == static_cast<int>(UpRule::kAlways));
  static_assert(Unit::HmtUpInterval == static_cast<int>(UpRule::kInterval));
  static_assert(Unit::HmtUpEvenAxis == static_cast<int>(UpRule::kEvenAxis));
  static_assert(Unit::HmtUpBothEven == static_cast<int>(UpRule::kBothEven));
  static_assert(Unit::HmtUpSelective == static_cast<int>(UpRule::kSelective));
  static_assert(Unit::HmtUpSelectiveEven == static_cast<int>(UpRule::kSelectiveEven));
  static_assert(Unit::HmtUpCoherent == static_cast<int>(UpRule::kCoherent));
  static_assert(Unit::HmtFaceNone == static_cast<int>(HitFace::kNone));
  static_assert(Unit::HmtFaceTop == static_cast<int>(HitFace::kTop));
  static_assert(Unit::HmtFaceWallX == static_cast<int>(HitFace::kWallX));
  static_assert(Unit::HmtFaceWallY == static_cast<int>(HitFace::kWallY));
  static_assert(Unit::HmtFaceInside == static_cast<int>(HitFace::kInside));
  static_assert(Unit::HmtSlotBubble == static_cast<int>(HmtTopPort::Slot::kBubble));
  static_assert(Unit::HmtSlotStep == static_cast<int>(HmtTopPort::Slot::kStep));
  static_assert(Unit::HmtSlotMiss == static_cast<int>(HmtTopPort::Slot::kMiss));
  static_assert(Unit::HmtSlotMerge == static_cast<int>(HmtTopPort::Slot::kMerge));
  static_assert(Unit::HmtSlotRefused == static_cast<int>(HmtTopPort::Slot::kRefused));
  static_assert(Unit::HmtSlotDead == static_cast<int>(HmtTopPort::Slot::kDead));
  static_assert(Unit::HmtSlotStall == static_cast<int>(HmtTopPort::Slot::kStall));
  static_assert((1 << Unit::HmtLevelBits) > kMostStopLevel);
  return true;
}

/// Compiles where the register map of the Verilated $unit `Unit` is hmt_registers.h's.
template <class Unit>
constexpr bool registers_are_tied() {
  static_assert(Unit::HmtAtMode == kRegisterMode);
  static_assert(Unit::HmtAtTimeEnd == kRegisterTimeEnd);
  static_assert(Unit::HmtAtRootBound == kRegisterRootBound);
  static_assert(Unit::HmtAtLevelBase == kRegisterLevelBase);
  static_assert(Unit::HmtAtCounter == kRegisterCounter);
  static_assert(Unit::HmtModeRootLevel == ModeField::kRootLevel);
  static_assert(Unit::HmtModeBorder == ModeField::kBorder);
  static_assert(Unit::HmtModeStart == ModeField::kStart);
  static_assert(Unit::HmtModeDown == ModeField::kDown);
  static_assert(Unit::HmtModeUp == ModeField::kUp);
  static_assert(Unit::HmtModeStopLevel == ModeField::kStopLevel);
  static_assert(Unit::HmtModeMorton == ModeField::kMorton);
  return true;
}

/// Says whether the widths of rtl/common/hmt_widths.sv, Verilated for the set, are those of the model's formulas.
template <class Widths>
constexpr bool widths_are_tied(const RtlParameters& p) {
  return Widths::HmtPositionBits == position_bits(p) && Widths::HmtPlaneBits == plane_bits(p) &&
         Widths::HmtProductBits == product_bits(p) && Widths::HmtTimeBits == width_of_time(p);
}

}  // namespace cuesta::rtl
