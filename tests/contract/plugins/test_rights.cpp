// Who may own and write to a plugin's file, its folder and the folders above, for users with and without a private group. As root
// all of it, as another user what he can set.
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "scratch.h"
#include "support/system.h"

namespace plugins {

namespace {

namespace fs = std::filesystem;

constexpr uid_t nobody_here = 54321;  // with no entry in the system's lists
constexpr uid_t somebody_else = 12345;
constexpr gid_t group_of_others = 12346;

struct Who {
  uid_t user;
  gid_t group;  // his first one
  bool group_is_his_own;
};

// A user of this system whose group has his name and nobody else.
std::optional<Who> user_with_private_group() {
  std::optional<Who> found;
  setpwent();
  while (const passwd* const user = found ? nullptr : getpwent()) {
    const group* const own = getgrgid(user->pw_gid);
    if (user->pw_uid != 0 && own && std::strcmp(own->gr_name, user->pw_name) == 0 && !*own->gr_mem)
      found = Who{user->pw_uid, user->pw_gid, true};
  }
  endpwent();
  return found;
}

std::vector<Who> users() {
  const passwd* const user = getpwuid(geteuid());
  const group* const own = user ? getgrgid(user->pw_gid) : nullptr;
  const bool alone = own && std::strcmp(own->gr_name, user->pw_name) == 0 && (!*own->gr_mem || !own->gr_mem[1]);
  std::vector<Who> all = {{geteuid(), user ? user->pw_gid : getegid(), alone}};
  if (geteuid() != 0) return all;
  all.push_back({nobody_here, nobody_here, false});
  if (const auto another = user_with_private_group()) all.push_back(*another);
  return all;
}

// Acts as that user while it lives.
class As {
 public:
  explicit As(uid_t user) : before_(geteuid()) { assert_int_equal(seteuid(user), 0); }
  ~As() { std::ignore = seteuid(before_); }
  As(const As&) = delete;
  As& operator=(const As&) = delete;

 private:
  uid_t before_;
};

// A plugin in above/folder, in the folder for temporary files, which is sticky in most systems.
class Tree {
 public:
  explicit Tree(const Who& who) : who_(who) {
    root = (fs::temp_directory_path() / "rc-rights-XXXXXX").string();
    assert_non_null(mkdtemp(root.data()));
    above = root + "/above";
    folder = above + "/folder";
    fs::create_directories(folder);
    file = folder + "/rcb_toy" RC_PLUGIN_SUFFIX;
    Scratch().put_as("toy", file);
    for (const std::string& path : {root, above, folder, file}) set(path, who.user, who.group, 0755);
  }
  ~Tree() {
    std::error_code left;
    fs::remove_all(root, left);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  void set(const std::string& path, uid_t owner, gid_t group, mode_t mode) const {
    if (geteuid() == 0) assert_int_equal(chown(path.c_str(), owner, group), 0);
    assert_int_equal(chmod(path.c_str(), mode), 0);
  }
  bool loads() const { return loads_from(folder); }
  bool loads_from(const std::string& path) const {
    const As user(who_.user);
    return Registry(path).names("toy") == RC_OK;
  }

  std::string root, above, folder, file;

 private:
  Who who_;
};

void the_owner_and_the_writers_decide(void**) {
  for (const Who& who : users()) {
    const Tree tree(who);
    assert_true(tree.loads());
    const bool root = geteuid() == 0;
    const std::vector<uid_t> owners = root ? std::vector<uid_t>{0, who.user, somebody_else} : std::vector<uid_t>{who.user};
    const std::vector<gid_t> groups = root ? std::vector<gid_t>{who.group, group_of_others} : std::vector<gid_t>{who.group};
    for (const std::string* const path : {&tree.file, &tree.folder, &tree.above}) {
      for (const uid_t owner : owners)
        for (const gid_t group : groups)
          for (const mode_t mode : {0755u, 0775u, 0757u, 0777u, 01777u, 01775u, 02755u, 02775u}) {
            const bool his = owner == 0 || owner == who.user;
            const bool own_group = who.group_is_his_own && group == who.group;
            const bool kept = path == &tree.above && (mode & S_ISVTX);
            const bool others = (mode & S_IWOTH) || ((mode & S_IWGRP) && !own_group);
            tree.set(*path, owner, group, mode);
            if (tree.loads() != (his && (kept || !others)))
              fail_msg("user %d: %s of %d:%d, mode %o: %s", static_cast<int>(who.user), path->c_str(), static_cast<int>(owner),
                       static_cast<int>(group), static_cast<unsigned>(mode), rc_last_error());
          }
      tree.set(*path, who.user, who.group, 0755);
    }
    assert_true(tree.loads());
  }
}

void folders_on_the_way_through_links_are_looked_at(void**) {
  for (const Who& who : users()) {
    const Tree tree(who), other(who);
    const std::string link = other.above + "/link", file_link = other.folder + "/rcb_toy" RC_PLUGIN_SUFFIX;
    fs::create_directory_symlink(tree.folder, link);
    fs::remove(other.file);
    fs::create_symlink("../../above/folder/../other", file_link);
    fs::create_symlink(tree.file, other.above + "/other");
    const std::array<std::string, 4> ways = {link, other.above + "/folder/../link/", link + "/.", other.folder};
    for (const std::string& way : ways) assert_true(tree.loads_from(way));
    for (const std::string* const path : {&tree.above, &tree.folder, &tree.file, &other.above, &other.root}) {
      tree.set(*path, who.user, who.group, 0757);
      for (const std::string& way : ways) assert_false(tree.loads_from(way));
      tree.set(*path, who.user, who.group, 0755);
    }
    tree.set(other.above, who.user, who.group, 01777);
    if (geteuid() == 0) {
      assert_int_equal(lchown(link.c_str(), somebody_else, who.group), 0);
      assert_false(tree.loads_from(link));
      assert_int_equal(lchown(link.c_str(), who.user, who.group), 0);
    }
    assert_true(tree.loads_from(link));
  }
}

void links_in_a_circle_are_refused(void**) {
  const Tree tree(users().front());
  fs::create_symlink("b", tree.above + "/a");
  fs::create_symlink("a", tree.above + "/b");
  assert_false(tree.loads_from(tree.above + "/a"));
}

// An access list may name users who may write although the group may be the user's own.
void an_access_list_is_refused_where_it_may_let_others_write(void**) {
  struct Entry {
    std::uint16_t tag, rights;
    std::uint32_t who;
  };
  struct {
    std::uint32_t version = 2;
    Entry entries[5] = {{1, 7, ~0u}, {2, 7, nobody_here}, {4, 5, ~0u}, {16, 7, ~0u}, {32, 5, ~0u}};
  } list;
  for (const Who& who : users()) {
    const Tree tree(who);
    for (const std::string* const path : {&tree.file, &tree.folder, &tree.above}) {
      list.entries[3].rights = 7;
      if (setxattr(path->c_str(), "system.posix_acl_access", &list, sizeof list, 0) != 0) skip();
      assert_false(tree.loads());
      list.entries[3].rights = 5;
      assert_int_equal(setxattr(path->c_str(), "system.posix_acl_access", &list, sizeof list, 0), 0);
      assert_true(tree.loads());
      assert_int_equal(removexattr(path->c_str(), "system.posix_acl_access"), 0);
    }
  }
}

void a_file_that_is_replaced_while_it_is_loaded_is_refused(void**) {
  const Tree tree(users().front());
  const std::string path = tree.folder + "/rcb_replaced" RC_PLUGIN_SUFFIX, other = tree.folder + "/other";
  Scratch().put_as("replaced", path);
  Scratch().put_as("replaced", other);
  support::set_variable("RC_TEST_REPLACED", path.c_str());
  support::set_variable("RC_TEST_BY", other.c_str());
  assert_int_equal(Registry(tree.folder).names("replaced"), RC_ERR_PLUGIN);
  assert_message_has("rcb_replaced" RC_PLUGIN_SUFFIX " was replaced while it was loaded");
  support::set_variable("RC_TEST_BY", nullptr);
  assert_true(Registry(tree.folder).lists("replaced"));
}

}  // namespace

}  // namespace plugins

int main() {
  using namespace plugins;
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_owner_and_the_writers_decide),
      cmocka_unit_test(folders_on_the_way_through_links_are_looked_at),
      cmocka_unit_test(links_in_a_circle_are_refused),
      cmocka_unit_test(an_access_list_is_refused_where_it_may_let_others_write),
      cmocka_unit_test(a_file_that_is_replaced_while_it_is_loaded_is_refused),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
