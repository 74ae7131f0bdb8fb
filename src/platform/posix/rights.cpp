#include "platform/posix/rights.h"

#include <grp.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <vector>

#include "platform/posix/system.h"

namespace rc_platform {

namespace {

constexpr int most_links = 40;  // as systems allow

// An entry of the system's list of users or groups, whose texts take any room.
template <class Entry, class Number> struct Listed {
  Entry entry{};
  std::vector<char> texts = std::vector<char>(1024);
  Entry* found = nullptr;

  Listed(int (*look_up)(Number, Entry*, char*, std::size_t, Entry**), Number number) {
    constexpr std::size_t most = 1 << 20;
    while (look_up(number, &entry, texts.data(), texts.size(), &found) == ERANGE && texts.size() < most)
      texts.resize(4 * texts.size());
  }
};

// The user's first group, which has his name and no other member: what he makes with umask 002 is his own.
bool is_private(gid_t group) {
  const Listed<passwd, uid_t> user(getpwuid_r, geteuid());
  if (!user.found || user.entry.pw_gid != group) return false;
  const Listed<struct group, gid_t> members(getgrgid_r, group);
  if (!members.found || std::strcmp(members.entry.gr_name, user.entry.pw_name) != 0) return false;
  for (char** member = members.entry.gr_mem; *member; ++member)
    if (std::strcmp(*member, user.entry.pw_name) != 0) return false;
  return true;
}

std::string foreign_owner(const std::string& what, const struct stat& info) {
  if (info.st_uid == 0 || info.st_uid == geteuid()) return {};
  return "plugin refused: " + what + " is owned by user " + std::to_string(info.st_uid) + ", neither root nor the current user " +
         std::to_string(geteuid());
}

// what: the path as the sentence names it.
std::string other_writers(const std::string& path, const std::string& what, const struct stat& info) {
  if (info.st_mode & S_IWOTH) return "plugin refused: " + what + " is world-writable; chmod o-w it";
  if (!(info.st_mode & S_IWGRP) || administers(info.st_gid)) return {};
  if (!is_private(info.st_gid))
    return "plugin refused: " + what + " can be written to by group " + std::to_string(info.st_gid) +
           ", which is not the private group of user " + std::to_string(geteuid()) + "; chmod g-w it";
  // With an access list, the mode's bits for the group are only an upper bound for all that the list names.
  if (has_access_list(path)) return "plugin refused: " + what + " has an access list, which may let others write; setfacl -b it";
  return {};
}

// The path that a link holds; "" if it cannot be read.
std::string target_of(const std::string& link) {
  char text[PATH_MAX];
  const ssize_t length = readlink(link.c_str(), text, sizeof text);
  return {text, length > 0 && static_cast<std::size_t>(length) < sizeof text ? static_cast<std::size_t>(length) : 0};
}

}  // namespace

std::string distrust(const std::string& path, const struct stat& file) {
  std::string reason = other_writers(path, path, file);
  return reason.empty() ? foreign_owner(path, file) : reason;
}

std::string distrust(const std::string& path) {
  std::string here, rest = path;  // rest: the names that follow, each after slashes
  int links = 0;
  for (;;) {
    struct stat info {};
    const std::string place = here.empty() ? "/" : here;
    if (lstat(place.c_str(), &info) != 0)
      return (rest.empty() ? "plugin " + path + " cannot be opened: " : "plugin directory " + place + ": ") +
             std::strerror(errno);

    const std::size_t name = rest.find_first_not_of('/');
    const std::size_t end = std::min(rest.find('/', name), rest.size());
    const bool above = name != std::string::npos && rest.find_first_not_of('/', end) != std::string::npos;
    const std::string what = above ? place + " (above " + path + ")" : place;
    if (S_ISLNK(info.st_mode)) {
      if (std::string reason = foreign_owner(what, info); !reason.empty()) return reason;
      const std::string target = target_of(place);
      if (target.empty() || ++links > most_links) return "plugin " + path + " cannot be opened: " + std::strerror(ELOOP);
      here = target[0] == '/' ? "" : here.substr(0, here.rfind('/'));
      rest = target + "/" + rest;
      continue;
    }
    // In a sticky folder others can neither rename nor remove what is not theirs.
    const bool kept = above && (info.st_mode & S_ISVTX) != 0;
    std::string reason = kept ? std::string() : other_writers(place, what, info);
    if (reason.empty()) reason = foreign_owner(what, info);
    if (!reason.empty() || name == std::string::npos) return reason;

    const std::string next = rest.substr(name, end - name);
    rest.erase(0, end);
    if (next == "..")
      here.erase(std::min(here.rfind('/'), here.size()));
    else if (next != ".")
      here += "/" + next;
  }
}

}  // namespace rc_platform
