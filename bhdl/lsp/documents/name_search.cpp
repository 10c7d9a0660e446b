// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/name_search.h"

#include <algorithm>
#include <set>

#include "bhdl/lsp/documents/constant_roles.h"

namespace galilean::bhdl::lsp {
namespace {

class Search {
 public:
  Search(const Workspace& workspace, const Name& name) : workspace_(workspace), name_(name) {}

  void start(const std::string& path) { to_visit_.push_back(path); }

  std::vector<Occurrence> run() {
    while (!to_visit_.empty()) {
      const std::string path = std::move(to_visit_.back());
      to_visit_.pop_back();
      if (!visited_.insert(path).second) continue;
      for (const auto& program : workspace_.programs_with(path)) search(program);
    }
    return std::move(found_);
  }

 private:
  void search(const ProgramFiles& program) {
    const bool may_be_constant = name_.space != NameSpace::kConstant;
    const ConstantRoles roles = may_be_constant ? constant_roles(program) : ConstantRoles();
    for (const auto& file : program) {
      for (const auto& mention : file->mentions().names)
        if (mention.space == name_.space && mention.name == name_.text)
          add({file, file->index.range_of(mention.name), mention.declares, mention.type});
      for (const auto& defined : file->mentions().defined)
        if (defined.is_text && defined.value == name_.text &&
            has_role(roles, defined.constant, name_.space))
          add({file, file->index.range_of(defined.value), false, {}});
    }
  }

  void add(Occurrence occurrence) {
    const std::string& path = occurrence.file->path;
    if (!seen_.emplace(path, occurrence.range.begin).second) return;
    to_visit_.push_back(path);
    found_.push_back(std::move(occurrence));
  }

  const Workspace& workspace_;
  const Name& name_;
  std::vector<std::string> to_visit_;
  std::set<std::string> visited_;
  std::set<std::pair<std::string, std::size_t>> seen_;
  std::vector<Occurrence> found_;
};

std::optional<NameAt> defined_name_at(const Workspace& workspace, const ParsedFile& file,
                                      std::size_t offset) {
  const auto touched = [&](const DefinedValue& each) {
    return each.is_text && file.index.range_of(each.value).touches(offset);
  };
  const auto found = std::ranges::find_if(file.mentions().defined, touched);
  if (found == file.mentions().defined.end()) return std::nullopt;
  for (const auto& program : workspace.programs_with(file.path)) {
    const ConstantRoles roles = constant_roles(program);
    for (const auto space : {NameSpace::kVariable, NameSpace::kPerceptualSchema,
                             NameSpace::kMotorSchema, NameSpace::kState})
      if (has_role(roles, found->constant, space))
        return NameAt{{space, std::string(found->value)}, file.index.range_of(found->value)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<NameAt> name_at(const Workspace& workspace, const ParsedFile& file,
                              std::size_t offset) {
  const auto touched = [&](const Mention& each) {
    return file.index.range_of(each.name).touches(offset);
  };
  const auto found = std::ranges::find_if(file.mentions().names, touched);
  if (found == file.mentions().names.end()) return defined_name_at(workspace, file, offset);
  return NameAt{{found->space, std::string(found->name)}, file.index.range_of(found->name)};
}

std::vector<Occurrence> occurrences(const Workspace& workspace, const std::string& path,
                                    const Name& name) {
  Search search(workspace, name);
  search.start(path);
  auto found = search.run();
  std::ranges::sort(found, [](const Occurrence& a, const Occurrence& b) {
    return std::tie(a.file->path, a.range.begin) < std::tie(b.file->path, b.range.begin);
  });
  return found;
}

std::vector<Occurrence> declarations(const Workspace& workspace, const std::string& path,
                                     const Name& name) {
  std::vector<Occurrence> found;
  std::set<std::string> searched;
  for (const auto& program : workspace.programs_with(path))
    for (const auto& file : program) {
      if (!searched.insert(file->path).second) continue;
      for (const auto& mention : file->mentions().names)
        if (mention.declares && mention.space == name.space && mention.name == name.text)
          found.push_back({file, file->index.range_of(mention.name), true, mention.type});
    }
  return found;
}

}  // namespace galilean::bhdl::lsp
