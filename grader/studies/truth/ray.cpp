#include "truth/ray.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace ggrade::truth {

template <auto release> struct Release {
  template <class T> void operator()(T* object) const { release(object); }
};
template <class Handle, auto release>
using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Release<release>>;

namespace {

void check(RTCDevice device) {
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree: error " + std::to_string(int(error)));
}

/// Lets go of triangles that are seen from behind.
void frontOnly(const RTCFilterFunctionNArguments* arguments) {
  // One ray at a time: the packet's first.
  const unsigned n = arguments->N;
  if (arguments->valid[0] == 0) return;
  const float along = RTCRayN_dir_x(arguments->ray, n, 0) * RTCHitN_Ng_x(arguments->hit, n, 0) +
                      RTCRayN_dir_y(arguments->ray, n, 0) * RTCHitN_Ng_y(arguments->hit, n, 0) +
                      RTCRayN_dir_z(arguments->ray, n, 0) * RTCHitN_Ng_z(arguments->hit, n, 0);
  if (along > 0) arguments->valid[0] = 0;
}

RTCRay rayOf(const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) {
  RTCRay ray{};
  ray.org_x = float(origin.x), ray.org_y = float(origin.y), ray.org_z = float(origin.z);
  ray.dir_x = float(direction.x), ray.dir_y = float(direction.y), ray.dir_z = float(direction.z);
  ray.tnear = float(from), ray.tfar = float(to);
  ray.mask = ~0u;
  return ray;
}

// What became of a query's context: arguments, in another order, in Embree 4.
#if RTC_VERSION_MAJOR >= 4
constexpr RTCSceneFlags kFiltersByQuery = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

void intersect(RTCScene scene, RTCRayHit& query, RTCFilterFunctionN filter) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.filter = filter;
  if (filter) arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  rtcIntersect1(scene, &query, &arguments);
}

void occlude(RTCScene scene, RTCRay& ray) {
  rtcOccluded1(scene, &ray);
}
#else
constexpr RTCSceneFlags kFiltersByQuery = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

void intersect(RTCScene scene, RTCRayHit& query, RTCFilterFunctionN filter) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.filter = filter;
  rtcIntersect1(scene, &context, &query);
}

void occlude(RTCScene scene, RTCRay& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
}
#endif

} // namespace

struct RayScene::Owned {
  std::vector<Triangles> meshes;
  Owner<RTCDevice, rtcReleaseDevice> device;
  Owner<RTCScene, rtcReleaseScene> scene;
};

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

RayScene::RayScene(std::vector<Triangles> meshes) : owned_(std::make_unique<Owned>()) {
  Owned& own = *owned_;
  own.meshes = std::move(meshes);
  own.device.reset(rtcNewDevice("threads=1"));
  if (!own.device) check(nullptr);
  RTCDevice device = own.device.get();
  own.scene.reset(rtcNewScene(device));
  rtcSetSceneFlags(own.scene.get(),
                   static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | kFiltersByQuery));
  for (const Triangles& mesh : own.meshes) {
    const std::size_t count = mesh.indices.size() / 3;
    if (std::ranges::any_of(mesh.indices, [&](auto i) { return i >= mesh.positions.size(); }))
      throw std::invalid_argument("a triangle has a corner that its mesh doesn't have");
    const Owner<RTCGeometry, rtcReleaseGeometry> geometry(
        rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
        std::max<std::size_t>(mesh.positions.size(), 1)));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), std::max<std::size_t>(count, 1)));
    check(device);
    for (const glm::dvec3& p : mesh.positions)
      for (int i = 0; i < 3; ++i) *vertices++ = float(p[i]);
    std::copy_n(mesh.indices.begin(), 3 * count, indices);
    if (count == 0) std::fill_n(indices, 3, 0);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(own.scene.get(), geometry.get());
  }
  rtcCommitScene(own.scene.get());
  check(device);
}

std::optional<Hit> RayScene::closestHit(const glm::dvec3& origin, const glm::dvec3& direction,
                                        double from, double to, Faces faces) const {
  RTCRayHit query{};
  query.ray = rayOf(origin, direction, from, to);
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect(owned_->scene.get(), query, faces == Faces::front ? frontOnly : nullptr);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  Hit hit;
  hit.mesh = query.hit.geomID, hit.triangle = query.hit.primID;
  const Triangles& mesh = owned_->meshes[hit.mesh];
  const std::uint32_t* corners = &mesh.indices[3 * std::size_t(hit.triangle)];
  const glm::dvec3 a = mesh.positions[corners[0]];
  const glm::dvec3 u = mesh.positions[corners[1]] - a, v = mesh.positions[corners[2]] - a;
  const glm::dvec3 across = glm::cross(u, v);
  hit.normal = glm::normalize(across);
  // Moeller and Trumbore 1997, all in double precision.
  const glm::dvec3 p = glm::cross(direction, v), toOrigin = origin - a;
  const double determinant = glm::dot(u, p);
  const glm::dvec3 q = glm::cross(toOrigin, u);
  double second = glm::dot(toOrigin, p) / determinant;
  double third = glm::dot(direction, q) / determinant;
  hit.distance = glm::dot(v, q) / determinant;
  // Seen nearly edge on, Embree's word is as good.
  if (!(std::abs(second - double(query.hit.u)) < 0.01 &&
        std::abs(third - double(query.hit.v)) < 0.01)) {
    second = double(query.hit.u), third = double(query.hit.v);
    hit.distance = double(query.ray.tfar);
  }
  hit.weights = {1 - second - third, second, third};
  return hit;
}

bool RayScene::occluded(const glm::dvec3& origin, const glm::dvec3& direction,
                        double distance) const {
  RTCRay ray = rayOf(origin, direction, 0, distance / glm::length(direction));
  occlude(owned_->scene.get(), ray);
  return ray.tfar < 0;
}

} // namespace ggrade::truth
