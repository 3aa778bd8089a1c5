#include "tautline/planners/contact_free/class_path_query.h"

#include "tautline/homotopy/socket.h"

namespace tautline {

Polyline OpenClassPathQuery::FromBase(Polyline path) const {
  if (base) path.insert(path.begin(), *base);
  return path;
}

std::optional<OpenClassPathQuery> LeaveSocket(const TautGround& ground, const ClassPathQuery& query) {
  const TautSpace& space = ground.space();
  const auto socket = FindSocket(space, ground.ungrown(), query.from);
  const auto to = space.Locate(query.to);
  if (!socket || !to) return std::nullopt;
  OpenClassPathQuery result{{socket->exit.point, to->point, query.word}, std::nullopt};
  if (socket->stub_length == 0) return result;
  const Point stub[] = {socket->base, socket->exit.point};
  result.open.word = space.rays().WordOf(stub).Inverse() * query.word;
  result.base = socket->base;
  return result;
}

}  // namespace tautline
