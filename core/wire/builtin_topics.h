// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>

#include <map>

#include "core/wire/entity.h"

namespace galilean::wire {

/// Brings `known` up to date: the live instances of one of DDS's built-in topics, by their handles.
template <class Sample, class Known>
void take_changes(const Entity& reader, std::map<dds_instance_handle_t, Known>& known,
                  Known (*read)(const Sample&)) {
  constexpr int kAtOnce = 64;
  void* samples[kAtOnce] = {};
  dds_sample_info_t infos[kAtOnce];
  for (int count; (count = dds_take(reader.handle(), samples, infos, kAtOnce, kAtOnce)) > 0;) {
    for (int i = 0; i < count; ++i) {
      if (infos[i].instance_state != DDS_ALIVE_INSTANCE_STATE)
        known.erase(infos[i].instance_handle);
      else if (infos[i].valid_data)
        known[infos[i].instance_handle] = read(*static_cast<Sample*>(samples[i]));
    }
    dds_return_loan(reader.handle(), samples, count);
  }
}

}  // namespace galilean::wire
