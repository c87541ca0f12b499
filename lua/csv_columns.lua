-- The metatable of what read_csv gives: data.name is the list of vecs of the columns name_x, name_y, name_z, or of
-- quaternions where there is name_w too; made when it is asked for.
return {
  __index = function(data, name)
    if type(name) ~= "string" then return nil end
    local function column(component)
      local values = rawget(data, name .. "_" .. component) or rawget(data, name .. "_" .. component .. "_rad")
      return values and math.type(values[1]) and values
    end
    local w, x, y, z = column "w", column "x", column "y", column "z"
    if not (x and y and z) then return nil end
    local list = {}
    for i = 1, #x do list[i] = w and quaternion(w[i], x[i], y[i], z[i]) or vec(x[i], y[i], z[i]) end
    return list
  end,
}
