// SPDX-License-Identifier: BSD-3-Clause
export const End: number;
export const SectionLabel: number;
export const StatesLabel: number;
export const DefineLabel: number;
export const ExpectLabel: number;
export const StateLabel: number;
export const ConditionLabel: number;
export const ListLabel: number;
export const IncludeLabel: number;
export const StartLabel: number;
export const SwapLabel: number;
export const ComponentLabel: number;
export const AttributeLabel: number;
export const Unit: number;
export const Word: number;
